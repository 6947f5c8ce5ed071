"""What joints, efforts and the IMU tell: the base's pose, a hand's force and touch."""
