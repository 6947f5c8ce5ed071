"""Motion problems for a Panda, made from a seed and written down as plain values."""
