"""What a detector tells, the stub that plays one, the range sensor and the map of rooms."""
