"""The robot on its way: what moves the whole body, step by step, and keeps it upright."""
