"""Standing: feed-forward, sway damping, and the watch on the soles' contact."""
