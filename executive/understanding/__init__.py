"""From a text or a model's output to commands: the parser's door and the conversation so far."""
