"""Look, detect, locate, and search from where the robot stands."""
