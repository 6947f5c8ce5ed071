"""What is spoken of: things, people, places and amounts, one or several."""
