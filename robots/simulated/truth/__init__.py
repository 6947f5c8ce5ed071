"""The simulator's truth, for tests, evaluation and the perception stub alone."""
