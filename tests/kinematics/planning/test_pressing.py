"""What of a closed hand comes to a button first, and how the hand is brought before it."""

import itertools

import coal
import numpy as np
import pinocchio as pin
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import stance_at
from kinematics.planning.control_planner import ControlPlanner
from kinematics.planning.pressing import pressing_faces
from kinematics.requests.control import ControlPlan, ControlRequest
from kinematics.requests.step import NoPlan
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from robots.models.description import load_description

SHORT_M, BUTTON_M = 0.035, np.array([0.38, 0.20, 0.84])
LONG_M, FRONT_M = 0.014, 0.30


@pytest.fixture(scope="module")
def g1():
    return RobotModel(load_description("g1"))


def closed_links(model, hand):
    """Corners of each link in the TCP frame, read anew from the whole robot with its fingers closed."""
    gripper, urdf = model.description.grippers[hand], model.description.urdf
    body = pin.buildModelFromXML(urdf, pin.JointModelFreeFlyer())
    solids = pin.buildGeomFromUrdfString(body, urdf, pin.GeometryType.COLLISION)
    q = pin.neutral(body)
    for motor in gripper.motors:
        q[body.idx_qs[body.getJointId(motor.joint)]] = motor.closed_rad
    data, placed = body.createData(), solids.createData()
    pin.framesForwardKinematics(body, data, q)
    pin.updateGeometryPlacements(body, data, solids, placed)
    tcp = data.oMf[body.getFrameId(gripper.tcp_frame)]
    links = {}
    for solid, at in zip(solids.geometryObjects, placed.oMg, strict=True):
        link = body.frames[solid.parentFrame].name
        if link in gripper.links:
            shape = solid.geometry
            corners = (
                shape.vertices()
                if isinstance(shape, coal.BVHModelBase)
                else shape.halfSide * np.array(list(itertools.product((-1.0, 1.0), repeat=3)))
            )
            links[link] = np.array([tcp.actInv(at).act(corner) for corner in np.asarray(corners)])
    return links


@pytest.mark.parametrize("hand", ["left", "right"])
def test_of_a_hand_turned_to_press_the_palm_comes_before_every_finger(g1, hand):
    links = closed_links(g1, hand)
    palm = links.pop(g1.description.grippers[hand].base_link)

    faces = pressing_faces(g1, hand, g1.q_home)

    assert faces
    for face in faces:
        inwards = face.tcp_R_face[:, 0]
        first_m = float((palm @ inwards).max())
        assert float(face.point_m @ inwards) == pytest.approx(first_m, abs=1e-6)
        assert max(float((link @ inwards).max()) for link in links.values()) < first_m - 0.005


def test_both_hands_are_turned_alike(g1):
    left, right = (pressing_faces(g1, hand, g1.q_home) for hand in ("left", "right"))

    across = np.diag([1.0, -1.0, 1.0])
    for one, other in zip(left, right, strict=True):
        np.testing.assert_allclose(one.tcp_R_face[:, 0], across @ other.tcp_R_face[:, 0], atol=1e-12)
        np.testing.assert_allclose(one.point_m, across @ other.point_m, atol=0.001)


def test_fingertips_that_meet_come_along_the_fingers(talos):
    (face,) = pressing_faces(talos, "left", talos.q_home)

    np.testing.assert_array_equal(face.tcp_R_face, np.eye(3))
    assert face.label == ""
    assert face.open_ahead_m == 0.0


def button_before(model, hand, at_m=BUTTON_M):
    """A button on the front of a box before one shoulder."""
    x, y, z = at_m * (1.0, 1.0 if hand == "left" else -1.0, 1.0)
    button, box = (
        SceneObject(name, Box(size), poses.translation(ahead, y, z), 0.005, movable=False)
        for name, size, ahead in (
            ("button", (LONG_M, 0.04, 0.04), x),
            ("box", (FRONT_M, 0.24, 0.2), x + 0.5 * (LONG_M + FRONT_M)),
        )
    )
    return ControlRequest(
        q_start=model.q_home,
        stance=stance_at(model, model.q_home),
        scene=PlanningScene().with_objects([button, box]),
        control="button",
        short_m=SHORT_M,
        hands=(hand,),
    )


@pytest.mark.parametrize("hand", ["left", "right"])
def test_a_palm_is_brought_square_before_a_button(g1, hand):
    request = button_before(g1, hand)

    plan = ControlPlanner(g1).plan(request)

    assert isinstance(plan, ControlPlan)
    frame = g1.description.grippers[hand].tcp_frame
    tcp = g1.frame_pose(plan.approach.trajectory.q[-1], frame)
    palm = closed_links(g1, hand)[g1.description.grippers[hand].base_link] @ tcp[:3, :3].T + tcp[:3, 3]
    first = palm[np.argmax(palm[:, 0])]
    button = request.scene.objects["button"].world_T_object[:3, 3]
    assert first[0] == pytest.approx(button[0] - 0.5 * LONG_M - plan.short_m, abs=0.003)
    assert palm[palm[:, 0] > first[0] - 0.003].mean(axis=0)[1:] == pytest.approx(button[1:], abs=0.006)
    # open fingers reach farther ahead than the palm: feeling begins before they meet the front
    assert plan.short_m > SHORT_M


def test_a_hand_whose_fingers_are_always_first_says_so(g1, monkeypatch):
    monkeypatch.setattr("kinematics.planning.pressing._CLEAR_M", 1.0)
    request = button_before(g1, "left")

    plan = ControlPlanner(g1.twin()).plan(request)

    assert isinstance(plan, NoPlan)
    assert plan.reasons == {"its fingers always come before its palm": 1}
