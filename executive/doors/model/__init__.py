"""The door to a language model: one OpenAI-compatible server, asked by a process of its own."""
