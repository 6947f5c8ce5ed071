"""What a look tells becomes what is believed, and nothing that it says nothing of is forgotten."""

from dataclasses import replace

import pytest
from py_trees.common import Status

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from kinematics.scene.planning_scene import SceneObject
from robots.fake.fake_world import cup, person, table
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE
from trees.nodes.ports import ports
from trees.skills.looking.look_around import LookAround

ANA = person("Ana", (1.3, 0.0))


class Look(LookAround):
    """A look that any sight satisfies."""

    INPUT_PORTS = ports()
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(precondition="none", postcondition="the world model is as seen", deadline_s=2.0)

    def found(self, seen):
        return DONE


def look(stage):
    leaf = Look("look", stage.toolbox)
    stage.ready(leaf)
    while stage.tick(leaf) is Status.RUNNING:
        pass
    assert leaf.status is Status.SUCCESS


@pytest.mark.requirement("P2")
def test_what_earlier_looks_told_of_a_person_stays_and_so_does_everything_else(stage_with):
    stage = stage_with(table(), replace(ANA, traits=("sitting",)))
    look(stage)
    world = stage.toolbox.world
    behind = SceneObject("shelf", Box((0.4, 1.0, 0.04)), poses.translation(-1.5, 0.0, 0.8), movable=False)
    world.update(world.scene.with_object(behind))
    stage.fake.world.put(replace(ANA, traits=()))
    for _ in range(30):  # until a picture shows it
        stage.fake.step()

    look(stage)

    scene = world.scene
    assert {"shelf", "Ana"} <= set(scene.objects)
    assert scene.objects["Ana"].label.traits == ("sitting",)


@pytest.mark.requirement("P2")
def test_every_look_remembers_how_things_were_seen(stage_with):
    stage = stage_with(table(), cup(place_m=(0.6, 0.0)))

    look(stage)

    assert "table" in stage.toolbox.world.sightings
