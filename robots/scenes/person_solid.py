"""The solid around a person, by how the person is."""

from __future__ import annotations

from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Box, Cylinder
from robots.scenes.scene_description import Person

PERSON_HEIGHT_M = 1.75
"""Of who stands."""
PERSON_REACH_M = 0.24
"""Radius around a person's axis that holds the whole body, arms included."""
SITTING_HEIGHT_M = 1.30
SITTING_REACH_M = 0.45
"""Radius around the middle of who sits that holds the thighs and shins."""
LYING_HEIGHT_M = 0.34
LYING_HALF_WIDTH_M = 0.30


def person_solid(person: Person, reach_m: float = PERSON_REACH_M) -> tuple[Cylinder | Box, Transform]:
    """A solid around a whole person, and its pose: x is where the person faces, or from the feet to the head.

    Args:
        person: Where and how the person is.
        reach_m: Radius around the axis of who stands.
    """
    shape = _shape(person, reach_m)
    turn = poses.rotation_z(person.yaw_rad)
    return shape, poses.transform(turn, (*person.position_m, 0.5 * shape.height_m))


def _shape(person: Person, reach_m: float) -> Cylinder | Box:
    match person.posture:
        case "sitting":
            return Cylinder(SITTING_REACH_M, SITTING_HEIGHT_M)
        case "lying":
            return Box((PERSON_HEIGHT_M, 2.0 * LYING_HALF_WIDTH_M, LYING_HEIGHT_M))
        case _:
            return Cylinder(reach_m, PERSON_HEIGHT_M)
