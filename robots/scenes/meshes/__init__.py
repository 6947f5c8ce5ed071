"""Objects whose shape is a mesh: what was made of it when it was imported, kept beside it."""
