"""How well stated confidences fit, and the line that makes them fit."""
