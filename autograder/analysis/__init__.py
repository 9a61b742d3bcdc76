"""What the results of a class say about its exercises and mistakes, and about its progress."""
