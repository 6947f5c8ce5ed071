"""Count, describe, find: answers about what is seen."""
