"""Suites about people who walk: following them, guiding them."""
