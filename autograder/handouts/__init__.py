"""What students receive: the handout, with stubs that are generated from the solutions."""
