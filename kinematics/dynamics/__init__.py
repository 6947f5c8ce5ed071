"""Loads of a standing robot: soles, zero-moment point, efforts."""
