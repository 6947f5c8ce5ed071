"""Nodes of trees: the leaf's life cycle, control nodes, judgements, wiring."""
