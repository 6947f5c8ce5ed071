"""Picks in which one sense is made to contradict another, and picks in which none is."""
