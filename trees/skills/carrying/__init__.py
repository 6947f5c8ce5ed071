"""What pick, place, hand over and put in share: getting a thing into a hand, keeping it, letting go."""
