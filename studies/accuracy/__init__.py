"""Speed against accuracy: the cost and the error of every model in the same scenes."""
