"""Run scenes on any engine, and return plain numbers. Pictures and studies use these runs."""
