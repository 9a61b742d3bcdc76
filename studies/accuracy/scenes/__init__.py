"""The scenes of the charts: their exact solutions, and the models that run them."""
