"""Suites of the household skills: a random room, a task, and a judge that knows the truth."""
