"""The lab's interactive scenes, in modules named after the book's chapters."""
