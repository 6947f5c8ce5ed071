"""The control process: server, motion desk, admission, bulletin, pacing."""
