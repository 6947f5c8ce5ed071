"""The robot served to other processes: the control process, its documents and its wire."""
