"""The scenes of the course, which the lab draws, the plots record and the studies measure.

They work with any engine, such as a student's own.
"""
