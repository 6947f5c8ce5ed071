"""Leaves that several skills use."""
