"""What the robot's camera makes of random scenes, judged by the simulator's truth."""
