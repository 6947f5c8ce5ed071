"""Grippers that open and close, hands that yield to what they hold."""
