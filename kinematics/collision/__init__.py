"""Whether configurations and edges are free, as the planner asks."""
