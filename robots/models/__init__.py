"""Robots as data: a folder for each, and how its description is read."""
