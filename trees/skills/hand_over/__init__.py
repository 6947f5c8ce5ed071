"""Give what is held to a person."""
