"""The judge of planned motions. It shares model, scene, motion and distance with the planner alone."""
