"""Faults that an evaluation plants in the world and in the body."""
