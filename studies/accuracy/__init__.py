"""Compare speed and accuracy, by measuring the cost and the error of every model in each scene."""
