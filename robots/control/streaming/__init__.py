"""Checked trajectories and what follows on them, played period by period."""
