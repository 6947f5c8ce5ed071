"""Things that were shown before, with pictures on them, told from each other on random tables."""
