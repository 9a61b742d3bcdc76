"""The plots of each chapter, which `make plot` draws with the functions of a student's engine."""
