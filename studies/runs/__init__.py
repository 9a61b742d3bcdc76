"""Run scenes on any engine, and return plain numbers for pictures and studies."""
