"""What a scene calls its things has nothing to do with what the robot's parts are called."""

import numpy as np
import pytest

from executive.session.assembly import assemble
from kinematics.geometry.shapes import Box
from robots.interface.hardware import RobotData
from robots.models.description import load_description, load_robot
from robots.scenes.scene_description import Furniture, MovingPart, Person, SceneDescription, SceneItem
from robots.simulated.body.body_model import pad_name, sole_name
from robots.simulated.body.geom_roles import Role
from robots.simulated.body.physics import Physics

HARDWARE = load_robot("talos").hardware

TALOS = load_description("talos")
OTHERS = ("floor", "world", "universe", "root", "gyro", "accelerometer", "sky", "cup/free", "scene:cup")


def named_as(name):
    """Every name of the robot's model, made a scene's where a scene may have it."""
    return name.replace("/", "|")


def names_of_the_robot():
    """What MuJoCo has a name for in a world that holds the robot alone."""
    model = Physics(RobotData(TALOS, HARDWARE), SceneDescription("empty")).model
    texts = model.names.split(b"\0")
    pads = [pad_name(link) for gripper in TALOS.grippers.values() for link in gripper.pad_links]
    soles = [sole_name(sole) for sole in TALOS.soles]
    given = {text.decode() for text in texts if text} | {*pads, *soles, *OTHERS}
    return sorted({named_as(name) for name in given})


def far_away(k):
    pose = np.eye(4)
    pose[:3, 3] = (4.0 + 0.3 * (k % 20), 4.0 + 0.3 * (k // 20), 0.05)
    return pose


def test_objects_may_be_called_as_anything_of_the_robot_or_the_floor():
    names = names_of_the_robot()
    assert len(names) > 100
    items = tuple(
        SceneItem(name, "box", "red", Box((0.1, 0.1, 0.1)), 0.2, 0.6, far_away(k))
        for k, name in enumerate(names)
    )
    plain = Physics(RobotData(TALOS, HARDWARE), SceneDescription("empty"))
    physics = Physics(RobotData(TALOS, HARDWARE), SceneDescription("odd", objects=items))

    assert [physics.geom_label[physics.object_geoms[name][0]] for name in names] == names
    assert all(physics.geom_role[physics.object_geoms[name][0]] == Role.OBJECT for name in names)
    for role in (Role.BODY, Role.FINGER, Role.PAD, Role.FLOOR):
        assert np.sum(physics.geom_role == role) == np.sum(plain.geom_role == role)


@pytest.mark.parametrize("name", ["floor", "arm_left_7_link"])
@pytest.mark.parametrize("what", ["table", "fridge", "person", "hollow"])
def test_furniture_people_and_hollow_things_may_be_called_so_too(what, name):
    door = MovingPart("left", 14.0, 2.0)
    scenes = {
        "table": SceneDescription("s", furniture=(Furniture(name, "table", (0.6, 1.2, 0.9), (2.0, 0.0)),)),
        "fridge": SceneDescription(
            "s", furniture=(Furniture(name, "fridge", (0.6, 0.6, 1.7), (2.0, 0.0), opens=door),)
        ),
        "person": SceneDescription("s", people=(Person(name, (2.0, 0.0), 3.14, takes=True),)),
        "hollow": SceneDescription(
            "s",
            objects=(SceneItem(name, "box", None, Box((0.2, 0.2, 0.1)), 0.5, 0.6, far_away(0), 0.006),),
        ),
    }

    truth = assemble("talos", scenes[what], 0).world.truth

    assert {solid.name.split("/")[0] for solid in truth.solids()} == {name}
    assert not truth.contacts.robot_touches_something()
