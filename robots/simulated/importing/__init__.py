"""Scenes and objects of somebody else's simulation, MJCF or URDF: what is in them, as files of ours."""
