"""Pictures for the chapters. The command `make plot` draws them with an engine's functions."""
