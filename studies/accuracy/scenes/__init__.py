"""The scenes of the accuracy study, with their exact solutions and the models that run them."""
