"""The scenes of the accuracy study, each with its exact solution and the models that run it."""
