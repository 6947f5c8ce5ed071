"""``python -m executive``."""

from executive.cli import main

main()
