"""What things are called: by shown examples, by a model, or by a package's detector."""
