"""Mark written answers on a web page on your own machine, one question at a time."""
