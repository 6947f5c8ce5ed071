"""Why something is asked for, which changes nothing."""
