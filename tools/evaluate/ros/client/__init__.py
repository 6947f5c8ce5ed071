"""The other side of suite ``ros_action``: a program that runs in a peer's environment."""
