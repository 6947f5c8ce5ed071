"""Whoever speaks to a served executive: the client commands and the service that starts it."""
