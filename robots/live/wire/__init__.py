"""Sockets, framing, messages and the state slot."""
