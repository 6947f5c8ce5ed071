"""What a planner is asked and what it answers, one module for each kind."""
