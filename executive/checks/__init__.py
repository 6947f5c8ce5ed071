"""What would happen, without moving: a sentence, a stored trajectory, a tree, this machine."""
