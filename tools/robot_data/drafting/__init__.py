"""A robot's folder drafted from its URDF: what can be measured is, what has to be guessed is listed."""
