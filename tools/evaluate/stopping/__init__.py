"""Stops and cancels at random instants of whole tasks, judged by the simulator's truth."""
