"""A conversation with a served robot in one terminal: commands, questions, stops, and what became of them."""
