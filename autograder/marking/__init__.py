"""Mark students' written answers on a local web page, one question at a time."""
