"""Grade where instructors already are: on Gradescope and GitHub Classroom."""
