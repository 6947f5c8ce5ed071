"""Where something was found is said from where the robot stands; the odometry frame is for programs."""

import math

import pytest
from py_trees.common import Status

from kinematics.geometry.planar import PlanarPose
from kinematics.geometry.poses import translation
from kinematics.geometry.shapes import Cylinder
from trees.beliefs.grounding.destination import Place
from trees.events import Said
from trees.skills.telling.tell_found import TellFound


@pytest.fixture
def told(stage):
    """What is said of a place at (1, 0.3) in the odometry frame after the robot has gone somewhere."""

    def say(gone, name="red cup", category="object"):
        stage.fake.motion.step_by(gone)
        stage.fake.step()
        place = Place(name, category, Cylinder(0.03, 0.11), translation(1.0, 0.3, 0.95), 0.9)
        assert stage.run(TellFound("tell", stage.toolbox), place=place) is Status.SUCCESS
        return next(event.text for event in stage.events if isinstance(event, Said))

    return say


@pytest.mark.parametrize(
    ("gone", "words"),
    [
        (PlanarPose(), "the red cup is 1.00 m ahead, 0.30 m to the left"),
        (PlanarPose(0.4, 0.3), "the red cup is 0.60 m ahead"),
        (PlanarPose(0.0, 0.0, math.pi), "the red cup is 1.00 m behind me, 0.30 m to the right"),
        (PlanarPose(0.5, 0.0, 0.5 * math.pi), "the red cup is 0.30 m ahead, 0.50 m to the right"),
    ],
)
def test_a_place_is_told_from_where_the_robot_stands_by_now(told, gone, words):
    assert told(gone) == words


def test_its_place_in_the_odometry_frame_is_the_evidence(stage, told):
    told(PlanarPose(0.0, 0.0, math.pi))

    evidence = stage.output("evidence")
    assert (evidence["x_m"], evidence["y_m"]) == pytest.approx((1.0, 0.3))


@pytest.mark.parametrize(
    ("name", "category", "called"),
    [("Ana", "person", "Ana is"), ("red cup 2", "object", "the red cup is")],
)
def test_people_are_called_by_name_and_things_without_their_number(told, name, category, called):
    assert told(PlanarPose(), name, category).startswith(called)
