"""The chapters' plots, which `make plot` draws with the functions of an engine."""
