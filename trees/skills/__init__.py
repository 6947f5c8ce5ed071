"""One folder a skill: its tree, its leaves, its geometry."""
