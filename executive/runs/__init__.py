"""One run from beginning to end, its log, and how it is found and replayed."""
