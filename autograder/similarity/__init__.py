"""Which submissions of a class resemble each other more than the class as a whole does."""
