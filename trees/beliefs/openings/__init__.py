"""Doors and drawers as they are believed to stand, and what is inside."""
