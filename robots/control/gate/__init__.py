"""The one way to the robot: authority, limits, refusals."""
