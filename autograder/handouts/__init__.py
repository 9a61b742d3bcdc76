"""Build the handout, the folder that students receive, with stubs made from our solutions."""
