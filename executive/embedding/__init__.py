"""The executive inside of another Python program: submit a sentence, hold its ticket."""
