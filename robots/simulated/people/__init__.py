"""Simulated people: where they walk, what they hold and take."""
