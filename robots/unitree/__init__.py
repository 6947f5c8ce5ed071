"""A humanoid of Unitree over its low-level interface: joints commanded and sensed by messages on the wire."""
