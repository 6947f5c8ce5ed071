"""From text to words: marks, names, hesitations, and what the vocabulary reads in them."""
