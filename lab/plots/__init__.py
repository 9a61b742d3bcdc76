"""Pictures of the chapters, drawn with the functions of an engine: `make plot`."""
