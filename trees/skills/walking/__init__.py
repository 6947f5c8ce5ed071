"""A walk over the floor within what the range sensor sees."""
