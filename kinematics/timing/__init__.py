"""From a path to a trajectory, within limits of velocity, acceleration, jerk and balance."""
