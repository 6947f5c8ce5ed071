"""A person's hands: keys that jog the robot, and what is so when the task is given back."""
