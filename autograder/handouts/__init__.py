"""Build the handout folder for students, with stubs that are generated from our solutions."""
