"""Back to the home posture, with whatever is in the hands."""
