"""Evaluate the opening and closing of doors and drawers."""
