"""What pictures and studies run: scenes on any engine, whose results are plain numbers."""
