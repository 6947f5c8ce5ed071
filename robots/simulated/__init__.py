"""The simulated robot in its world, on MuJoCo."""
