"""Speed against accuracy: the same scenes by every model, what each costs and how far off it is."""
