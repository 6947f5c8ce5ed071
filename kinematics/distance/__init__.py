"""Convex solids and how far apart they are: what the checker and the planner share."""
