"""What is believed of the world, as values; nothing here needs a toolbox."""
