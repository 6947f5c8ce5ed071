"""What every word stands for, and what harms or has to be asked."""
