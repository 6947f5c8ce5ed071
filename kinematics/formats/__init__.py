"""Trajectories, solids and their checks as documents."""
