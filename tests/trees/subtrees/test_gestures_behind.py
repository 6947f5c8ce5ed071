"""Gestures at who or what is behind the robot: it turns around where it gets back, among rooms."""

import dataclasses

import pytest

from robots.fake.fake_world import cup, person, table
from robots.scene_description import Region
from trees.build import build_tree
from trees.tasks import LookAtTask, ObjectDescription, PointAtTask, WaveTask

BEHIND = person("Ana", (-1.5, 0.3))
ROOMS = {"hall": Region("hall", (0.0, 0.0), (6.0, 6.0))}
GESTURES = [
    WaveTask("wave to Ana", "Ana"),
    LookAtTask("look at Ana", person="Ana"),
    PointAtTask("there", person="Ana"),
]


@pytest.mark.requirement("M3")
@pytest.mark.parametrize("task", GESTURES)
@pytest.mark.parametrize(("places", "status"), [(ROOMS, "success"), ({}, "failure")])
def test_who_is_behind_is_turned_to_among_rooms(new_stage, task, places, status):
    stage = new_stage(walks=True)
    if places:
        stage.when("turn around", lambda: stage.fake.world.put(BEHIND))

    tree = stage.play(build_tree(task, dataclasses.replace(stage.toolbox, places=places)))

    assert tree.status == status
    assert status == "success" or tree.failure.root.message == "no Ana seen"


def test_nobody_turns_around_from_what_is_in_view(new_stage):
    stage = new_stage(table(), cup(), walks=True)

    tree = stage.play(
        build_tree(
            PointAtTask("there", ObjectDescription("cup")), dataclasses.replace(stage.toolbox, places=ROOMS)
        )
    )

    assert tree.status == "success"
    assert not [event for event in stage.events if "viewpoint" in getattr(event, "where", "")]
