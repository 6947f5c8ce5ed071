"""Where to walk: the room that is free, the way through it, where it stops."""
