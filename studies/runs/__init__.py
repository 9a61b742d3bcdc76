"""Run scenes on any engine, and return plain numbers for plots and studies."""
