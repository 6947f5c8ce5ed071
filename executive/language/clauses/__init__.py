"""What stands around a command, and how commands are joined."""
