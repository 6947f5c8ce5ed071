"""Standing and walking while something disturbs: pushes, errors of the sensors, another floor."""
