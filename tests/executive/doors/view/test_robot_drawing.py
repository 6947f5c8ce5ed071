"""Frames of a robot as the page has them, against Pinocchio's forward kinematics."""

import numpy as np
import pytest

from executive.doors.view.robot_drawing import ROOT, MovingFrames, lightened
from kinematics.geometry import poses
from kinematics.model.robot_model import RobotModel
from robots.models.description import load_description

ROBOTS = ("talos", "g1", "panda")


@pytest.fixture(params=ROBOTS)
def model(request):
    return RobotModel(load_description(request.param))


@pytest.fixture
def frames(model):
    description = model.description
    return MovingFrames(description.urdf, description.actuated, description.base_link)


def pose(row):
    x, y, z, w, a, b, c = row
    return poses.transform(poses.rotation_from_quaternion(np.array([a, b, c, w])), (x, y, z))


def world_pose(path, local):
    """Of a frame: the product of those above it."""
    names = path.split("/")[1:]
    made = np.eye(4)
    for end in range(1, len(names) + 1):
        made = made @ local.get("/" + "/".join(names[:end]), np.eye(4))
    return made


def test_links_are_where_pinocchio_has_them(model, frames):
    description, rng = model.description, np.random.default_rng(3)
    q = model.q_home.copy()
    q[7:] = rng.uniform(model.lower_rad, model.upper_rad)
    turn = rng.normal(size=4)
    q[:7] = [0.4, -0.2, 1.0, *(turn / np.linalg.norm(turn))]
    hands = [description.home[name] for name in description.gripper_joints]

    moved = frames.moved(np.concatenate([q[7:], hands]), q[:7])
    local = {path: pose(row) for path, row in moved.items()}
    local |= {path: pose(np.concatenate(fixed)) for path, fixed in frames.fixed.items()}

    for link in [model.moved_links[name] for name in model.joints]:
        assert world_pose(frames.paths[link], local) == pytest.approx(model.frame_pose(q, link), abs=1e-6)


def test_only_what_has_moved_is_drawn_again(model, frames):
    joints = np.zeros(len(model.description.actuated))
    base = np.array([0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0])
    first = frames.moved(joints, base)
    joints[0] += 0.1
    second = frames.moved(joints, base)
    base[0] += 0.01
    third = frames.moved(joints, base)

    assert len(first) > len(joints)
    assert list(second) == [frames.paths[model.moved_links[model.description.actuated[0]]]]
    assert list(third) == [ROOT]


def test_what_trembles_is_not_drawn_again_but_a_slow_drift_is(model, frames):
    joints, base = np.zeros(len(model.description.actuated)), np.array([0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0])
    frames.moved(joints, base)

    drawn = []
    for step in range(100):
        base[0] = 1e-5 * step
        drawn += list(frames.moved(joints, base))

    assert 1 <= len(drawn) <= 5


def test_black_is_made_lighter_and_colours_stay():
    assert min(lightened((0, 0, 0))) > 80
    assert lightened((250, 120, 0)) == (250, 120, 0)
