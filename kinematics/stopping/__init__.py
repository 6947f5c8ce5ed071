"""Braking along a path, at once, and going on from there."""
