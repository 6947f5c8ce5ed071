"""Say and wait."""
