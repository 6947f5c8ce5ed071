"""What may be wrong with a body, noticed from its own sensors."""
