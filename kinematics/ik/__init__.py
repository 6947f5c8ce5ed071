"""Inverse kinematics of the standing body, of the gaze and of pointing."""
