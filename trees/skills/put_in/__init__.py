"""Put what is held into a container, behind a door if need be."""
