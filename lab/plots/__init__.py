"""The pictures of the chapters, which `make plot` draws with the functions of an engine."""
