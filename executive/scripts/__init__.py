"""Task scripts: their file, their order, their run."""
