"""What can be seen from where, and what is hidden."""
