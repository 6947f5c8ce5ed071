"""What a leaf reads off the toolbox: odometry, hands, touch, what is around."""
