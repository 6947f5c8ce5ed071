"""The planners, one for each kind of request."""
