"""Furniture that opens: where it stands, how far it is open, and where its handle is."""
