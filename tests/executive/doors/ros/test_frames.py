"""The frames of a robot, against Pinocchio's."""

import numpy as np
import pinocchio as pin
import pytest

from executive.doors.ros.frames import FrameTree
from robots.models.description import load_description

pytestmark = pytest.mark.requirement("U3")


@pytest.fixture(scope="module", params=["talos", "panda"])
def description(request):
    return load_description(request.param)


def chained(tree, positions, root):
    """Pose of every link in the root, from the frames between them."""
    places, turns = tree.poses(positions)
    moving = zip(tree.moving, places, turns, strict=True)
    edges = [(*pair, place, turn) for pair, place, turn in moving]
    edges += [(parent, child, np.array(xyz), np.array(turn)) for parent, child, xyz, turn in tree.fixed]
    poses, left = {root: pin.SE3.Identity()}, edges
    while left:
        known = [edge for edge in left if edge[0] in poses]
        if not known:
            return poses
        for parent, child, place, turn in known:
            poses[child] = poses[parent] * pin.SE3(pin.Quaternion(np.array(turn)).matrix(), np.array(place))
        left = [edge for edge in left if edge[1] not in poses]
    return poses


def test_every_link_is_where_pinocchio_has_it(description):
    names = list(description.actuated)
    tree, model = FrameTree(description.urdf, names), pin.buildModelFromXML(description.urdf)
    data, rng = model.createData(), np.random.default_rng(2)
    for _ in range(5):
        positions = rng.uniform(-0.5, 0.5, len(names))
        q = pin.neutral(model)
        for name, value in zip(names, positions, strict=True):
            joint = model.joints[model.getJointId(name)]
            if joint.nq == 1:
                q[joint.idx_q] = value
            else:
                q[joint.idx_q : joint.idx_q + 2] = np.cos(value), np.sin(value)
        pin.framesForwardKinematics(model, data, q)
        root = description.base_link
        base = data.oMf[model.getFrameId(root)]
        for link, pose in chained(tree, positions, root).items():
            if link in _below_mimics(description.urdf):
                continue
            theirs = base.actInv(data.oMf[model.getFrameId(link)])
            assert np.allclose(pose.homogeneous, theirs.homogeneous, atol=1e-9), link


def _below_mimics(urdf):
    """Links that follow another joint: Pinocchio's plain model moves them by themselves."""
    import xml.etree.ElementTree as ElementTree

    joints = [one for one in ElementTree.fromstring(urdf).iter("joint") if one.find("parent") is not None]
    below = {one.find("child").get("link") for one in joints if one.find("mimic") is not None}
    while (
        more := {one.find("child").get("link") for one in joints if one.find("parent").get("link") in below}
        - below
    ):
        below |= more
    return below


MIMIC = """<robot name="r"><link name="a"/><link name="b"/><link name="c"/>
<joint name="lead" type="revolute"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/></joint>
<joint name="back" type="prismatic"><parent link="b"/><child link="c"/><axis xyz="1 0 0"/>
<mimic joint="lead" multiplier="-2" offset="0.1"/></joint></robot>"""


def test_a_joint_that_mimics_another_follows_it():
    places, turns = FrameTree(MIMIC, ["lead"]).poses(np.array([0.3]))

    assert places[1] == pytest.approx([-0.5, 0.0, 0.0])
    assert turns[0] == pytest.approx([0.0, 0.0, np.sin(0.15), np.cos(0.15)])
