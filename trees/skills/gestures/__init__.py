"""Wave, point at, look at."""
