"""Open and close hinged doors and drawers."""
