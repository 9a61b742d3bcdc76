"""What a student's commands show and do: check, watch, hint and reset."""
