"""Find the submissions of a class, and copy the files to be graded.

Students may hand in anything, so no submission is trusted.
"""
