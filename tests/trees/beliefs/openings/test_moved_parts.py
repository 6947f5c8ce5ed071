"""A door that was opened stands in the scene once."""

import numpy as np

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from robots.perception.object_estimate import ObjectEstimate
from trees.beliefs.openings.moved_parts import without_moved_parts

PANEL = Box((0.04, 0.6, 1.6))


def believed(**places):
    return PlanningScene().with_objects(
        SceneObject(name.replace("_", " "), PANEL, poses.translation(*at), movable=False)
        for name, at in places.items()
    )


def seen(kind, at, yaw_rad=0.0):
    pose = poses.transform(poses.rotation_z(yaw_rad), at)
    return ObjectEstimate("furniture", kind, None, pose, PANEL, 0.9, 8, 0.0)


SWUNG = (5.5 - 0.3 * np.sin(1.2), 1.2 - 0.3 * np.cos(1.2), 0.9)
"""The door of the tests, opened by 1.2 rad about its left edge."""


def test_a_door_that_is_seen_elsewhere_replaces_the_one_that_was_believed():
    scene = believed(door=(5.5, 0.9, 0.9), wall=(2.4, 0.0, 0.9))

    left = without_moved_parts(scene, [seen("door", SWUNG, -1.2)])

    assert "wall" in left.objects
    assert "door" not in left.objects


def test_a_door_far_away_is_another_one():
    scene = believed(door=(5.5, 0.9, 0.9), door_2=(0.5, -2.0, 0.9))

    left = without_moved_parts(scene, [seen("door", SWUNG, -1.2)])

    assert "door 2" in left.objects
    assert "door" not in left.objects


def test_the_door_beside_it_is_another_one_with_its_handle():
    scene = believed(
        door=(5.5, 0.9, 0.9), handle=(5.4, 0.65, 0.9), door_2=(5.5, 0.1, 0.9), handle_2=(5.4, -0.15, 0.9)
    )

    left = without_moved_parts(scene, [seen("door", SWUNG, -1.2), seen("handle", (5.0, 1.0, 0.9))])

    assert set(left.objects) == {"door 2", "handle 2"}


def test_the_drawer_of_the_chest_beside_it_is_another_one():
    scene = believed(drawer=(0.7, 0.4, 0.9), drawer_2=(0.7, -0.4, 0.9))

    left = without_moved_parts(scene, [seen("drawer", (0.45, -0.4, 0.9))])

    assert set(left.objects) == {"drawer"}


def test_a_look_that_shows_no_door_changes_nothing():
    scene = believed(door=(5.5, 0.9, 0.9))

    assert without_moved_parts(scene, [seen("wall", (5.5, 0.9, 0.9))]) is scene
