"""A hand at a handle or a front: come near, grasp it, lead it along its path, step back."""
