"""Suites over the ROS door: velocities that fall silent, hostile samples, and tasks by an action."""
