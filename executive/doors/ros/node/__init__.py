"""A node for those who have rclpy, their own ROS or its wheels; nothing of the product imports it."""
