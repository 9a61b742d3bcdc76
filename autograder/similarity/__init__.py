"""Find pairs of submissions that are more alike than is usual for their class."""
