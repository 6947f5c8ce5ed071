"""Runs of a suite in which something is killed on purpose, beside one that is left alone."""
