"""The fake robot in front of a table with a cup."""

import pytest

from kinematics.model.robot_model import RobotModel
from kinematics.motion.verdict import CheckedTrajectory
from robots.fake.fake_world import FakeWorld, cup, table
from robots.models.description import load_description, load_robot

HARDWARE = load_robot("talos").hardware


def believed(request):
    """What a checker that finds nothing would answer; only tests may make one up."""
    checked = object.__new__(CheckedTrajectory)
    for name, value in {"trajectory": request.trajectory}.items():
        object.__setattr__(checked, name, value)
    return checked


@pytest.fixture(scope="session")
def model():
    return RobotModel(load_description("talos"))


def in_front_of_a_table(model):
    world = FakeWorld(model, HARDWARE, believed, [table(), cup()])
    world.step()
    return world


@pytest.fixture
def fake(model):
    return in_front_of_a_table(model)


@pytest.fixture
def fake_again(model):
    """Another one of the same."""
    return in_front_of_a_table(model)


@pytest.fixture
def play(fake):
    """Carry a handle out to its end."""

    def until_finished(handle):
        for _ in range(500):
            if handle.finished:
                return handle
            fake.step()
        raise AssertionError(f"{handle.name} never ended")

    return until_finished
