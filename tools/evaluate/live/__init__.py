"""Suites over the served robot: kill, connection, fuzz, load."""
