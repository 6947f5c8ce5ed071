"""Suites over the door of the Model Context Protocol: tasks whose clients come and go, and hostile calls."""
