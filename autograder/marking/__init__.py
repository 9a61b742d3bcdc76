"""Mark written answers on a local page, one question at a time."""
