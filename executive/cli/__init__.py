"""The command line: the application and its commands."""
