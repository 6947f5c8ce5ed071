"""Suites of what is put on top of other things, on their named parts, and of lids."""
