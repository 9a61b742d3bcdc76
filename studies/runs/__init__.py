"""Runs of scenes on any engine, which return plain numbers. Pictures and studies use them."""
