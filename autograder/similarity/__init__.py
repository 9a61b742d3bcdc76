"""Find submissions of a class that resemble each other more than the class as a whole does."""
