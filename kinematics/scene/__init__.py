"""The planning scene, and where in it things may stand, move and be seen."""
