"""Poses, shapes and curves of one variable."""
