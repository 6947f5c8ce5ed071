"""A door that was opened stands in the scene once."""

from kinematics import poses
from kinematics.scene import PlanningScene, SceneObject
from kinematics.shapes import Box
from robots.perception.object_estimate import ObjectEstimate
from trees.handles import without_moved_parts

PANEL = Box((0.04, 0.6, 1.6))


def believed(**places):
    return PlanningScene().with_objects(
        SceneObject(name.replace("_", " "), PANEL, poses.translation(*at), movable=False)
        for name, at in places.items()
    )


def seen(kind, at):
    return ObjectEstimate("furniture", kind, None, poses.translation(*at), PANEL, 0.9, 8, 0.0)


def test_a_door_that_is_seen_elsewhere_replaces_the_one_that_was_believed():
    scene = believed(door=(5.5, 0.9, 0.9), wall=(2.4, 0.0, 0.9))

    left = without_moved_parts(scene, [seen("door", (5.2, 1.2, 0.9))])

    assert "wall" in left.objects
    assert "door" not in left.objects


def test_a_door_far_away_is_another_one():
    scene = believed(door=(5.5, 0.9, 0.9), door_2=(0.5, -2.0, 0.9))

    left = without_moved_parts(scene, [seen("door", (5.2, 1.2, 0.9))])

    assert "door 2" in left.objects
    assert "door" not in left.objects


def test_a_look_that_shows_no_door_changes_nothing():
    scene = believed(door=(5.5, 0.9, 0.9))

    assert without_moved_parts(scene, [seen("wall", (5.5, 0.9, 0.9))]) is scene
