"""What is corrected, contrasted or taken back."""
