"""How often the control loop goes round."""

PERIOD_S = 0.002
"""500 Hz."""
