"""Walking as values: footsteps, the CoM's pattern, whole-body references, wrenches, odometry."""
