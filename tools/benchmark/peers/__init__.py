"""Libraries that a user would otherwise take, each run in an environment of its own."""
