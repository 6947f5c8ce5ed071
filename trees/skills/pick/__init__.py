"""Pick an object up."""
