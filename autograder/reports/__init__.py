"""Write the results of grading: reports, feedback pages, a gradebook, and files for Gradescope."""
