"""Scenes: their files, their furniture, and the rules that they keep."""
