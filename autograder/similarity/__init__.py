"""Find pairs of students whose code is more alike than is usual in their class."""
