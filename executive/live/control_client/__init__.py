"""The control process as the executive uses it: links, clients of motion, walking and planning."""
