"""What is told of a run: lines, explanations, the report and the safety tally."""
