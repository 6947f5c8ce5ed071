"""Believed things and furniture, and how a look changes them."""
