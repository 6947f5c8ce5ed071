"""What stands beside a served robot, as a user has it: its page and its recorder."""
