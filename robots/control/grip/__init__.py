"""Joints of a gripper as they are commanded and kept."""
