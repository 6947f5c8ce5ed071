"""The other side of Unitree's low-level interface, for trying what speaks it."""
