"""Footsteps and the motion of the centre of mass that goes with them."""
