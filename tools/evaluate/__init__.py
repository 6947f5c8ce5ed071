"""Random episodes, judged by the simulator's truth."""
