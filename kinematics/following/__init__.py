"""A hand that follows a path as it goes, one step at a time."""
