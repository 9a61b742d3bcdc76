"""The page of all charts: speed against accuracy, for every scene and every model."""
