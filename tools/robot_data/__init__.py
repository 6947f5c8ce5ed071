"""Data of a robot that are computed once: pairs, reach, standing places."""
