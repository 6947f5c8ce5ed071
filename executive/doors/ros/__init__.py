"""ROS 2 on the wire, by a DDS of its own; ROS is not installed and not needed."""
