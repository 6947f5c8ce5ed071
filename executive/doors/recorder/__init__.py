"""A run kept in motion: joints, frames, beliefs, tree and events as ROS 2 messages in an MCAP file."""
