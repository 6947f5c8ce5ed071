"""The whole body that follows a walking pattern, and what it senses meanwhile."""
