"""Find pairs of submissions that are more similar than is usual in their class."""
