"""The ROS door beside a bare pair of DDS."""
