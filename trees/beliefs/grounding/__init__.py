"""From a description to the thing that is meant."""
