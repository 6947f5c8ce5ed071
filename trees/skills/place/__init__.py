"""Put what is held down."""
