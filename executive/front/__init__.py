"""A language model in front: what it proposes is parsed, grounded in the user's words, and read back."""
