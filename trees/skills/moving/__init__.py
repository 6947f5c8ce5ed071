"""Velocities for a while."""
