"""Trajectories and the verdict on them: path, time, samples, findings."""
