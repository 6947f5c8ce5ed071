"""Walk to furniture, things, people and rooms."""
