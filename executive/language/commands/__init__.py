"""What each command means, by its verb."""
