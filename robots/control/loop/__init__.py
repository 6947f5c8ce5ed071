"""The control loop, its safeguards, its stop and its record."""
