"""From a task as it was said to one that can be carried out here and now."""
