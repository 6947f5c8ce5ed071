"""The live tree in Groot2: its monitoring protocol, at a port of this machine."""
