"""The robot as a server of the Model Context Protocol: few tools, none of which can reset it."""
