"""The robot as geometry: description, model, stance, support polygon, forward kinematics."""
