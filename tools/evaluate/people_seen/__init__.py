"""What the robot's camera makes of random people, judged by the scene."""
