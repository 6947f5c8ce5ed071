"""Shapes as Coal has them."""

from __future__ import annotations

import coal

from kinematics.geometry.shapes import Ball, Box, Shape


def coal_shape(shape: Shape) -> coal.CollisionGeometry:
    """Coal's solid of a shape."""
    if isinstance(shape, Box):
        return coal.Box(*shape.size_m)
    if isinstance(shape, Ball):
        return coal.Sphere(shape.radius_m)
    return coal.Cylinder(shape.radius_m, shape.height_m)
