"""The robot's own camera: pictures drawn on request, in a process of their own, with a real one's errors."""
