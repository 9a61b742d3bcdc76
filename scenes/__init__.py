"""The scenes of the course, such as a ball on a spring, each described once.

The lab draws them, the plots record them, and the studies measure them. Each module describes one
scene, or a few similar ones: its parameters, particles, forces and contacts, and its exact solution
if it has one. The scenes work with any engine, such as a student's own.
"""
