"""Values of the robot as they cross a socket."""
