"""What students receive: the hand-out, with stubs that are generated from the solutions."""
