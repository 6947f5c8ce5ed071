"""Suites in which a scripted person jogs the robot by keys."""
