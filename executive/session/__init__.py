"""One robot, one tree at a time: the session, its life cycle, its events and its assembly."""
