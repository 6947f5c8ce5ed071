"""The served robot as the executive and its callers see it, each a process of its own."""
