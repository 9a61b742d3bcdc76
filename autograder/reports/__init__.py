"""Write down the results of grading: reports, feedback pages, gradebook and Gradescope's files."""
