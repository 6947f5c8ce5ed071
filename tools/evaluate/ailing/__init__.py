"""Motors and sensors that fail at random instants of whole tasks."""
