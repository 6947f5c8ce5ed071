"""Look from elsewhere: which furniture, which room, which outlook."""
