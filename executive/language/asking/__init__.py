"""What a sentence leaves open, as a question that can be answered."""
