"""A robot of scripts and straight lines, for tests and rehearsals without a simulator."""
