"""A way between two upright postures may lean what a hand holds, and is not taken where that is asked for."""

from types import SimpleNamespace

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Cylinder
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import stance_at
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.curves import PolynomialCurve
from kinematics.planning import held_lean, move_planner
from kinematics.planning.held_lean import leaned_rad, least_leaning, level_way
from kinematics.requests.move import MovePlan, MoveRequest
from kinematics.requests.step import NoPlan
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from kinematics.standing.free_coordinates import free_coordinates
from robots.models.description import load_description

ROLL = "right_wrist_roll_joint"


@pytest.fixture(scope="module")
def model():
    return RobotModel(load_description("g1"))


def holding(model):
    frame = model.description.tcp_frames["right"]
    upright = poses.transform(model.frame_pose(model.q_home, frame)[:3, :3].T, (0.0, 0.0, 0.0))
    cup = SceneObject("cup", Cylinder(0.03, 0.1), upright)
    links = model.description.grippers["right"].touch_links
    return PlanningScene().with_objects([cup]).with_attached("cup", frame, upright, links)


def there_and_back(model, rolled_rad):
    """A curve that rolls the wrist and is at its beginning again in the end."""
    space = free_coordinates(StandingRobot.of(model, stance_at(model, model.q_home)))
    start = space.from_q(model.q_home)
    rolled = start.copy()
    rolled[space.index(ROLL)] += rolled_rad
    return space, PolynomialCurve(np.array([start, rolled, start]))


@pytest.mark.parametrize("rolled_rad", [0.2, 0.5])
def test_a_lean_on_the_way_is_found(model, rolled_rad):
    space, curve = there_and_back(model, rolled_rad)

    # the forearm is not level: the roll turns the cup by a little less
    assert leaned_rad(model, space, curve, holding(model)) == pytest.approx(rolled_rad, rel=0.1)


def test_empty_hands_lean_nothing(model):
    space, curve = there_and_back(model, 0.5)

    assert leaned_rad(model, space, curve, PlanningScene()) == 0.0


@pytest.mark.parametrize(("level", "answer"), [(True, NoPlan), (False, MovePlan)])
def test_a_way_that_leans_it_is_no_way_where_that_is_asked_for(model, monkeypatch, level, answer):
    monkeypatch.setattr(held_lean, "leaned_rad", lambda *_: 0.4)
    stance = stance_at(model, model.q_home)
    request = MoveRequest(
        model.q_home, stance, holding(model), {"waist_yaw_joint": 0.2}, keep_others=True, level=level
    )

    assert isinstance(move_planner.plan_move(model, request), answer)


@pytest.fixture(scope="module")
def between(model):
    """Two postures that hold a cup as upright as each other, between which a straight line leans it."""
    space = free_coordinates(StandingRobot.of(model, stance_at(model, model.q_home)))
    frame = model.description.tcp_frames["right"]
    start = space.from_q(model.q_home)
    far = start.copy()
    for joint, turn in {"right_shoulder_roll_joint": -0.7, "right_elbow_joint": -0.6, ROLL: 0.5}.items():
        far[space.index(joint)] += turn
    scene = holding(model)
    axis = scene.attached["cup"].frame_T_object[:3, 2]
    arm = model.description.groups["right_arm"]
    wrist = [space.index(joint) for joint in arm]
    for _ in range(30):
        q = space.to_q(far[None, :])[0][0]
        up = model.frame_pose(q, frame)[:3, :3] @ axis
        turns = model.frame_jacobian(q, frame)[3:, 6 + model.indices(arm)]
        across = turns - np.outer(up, up @ turns)
        far[wrist] += np.linalg.lstsq(across, np.cross(up, [0.0, 0.0, 1.0]), rcond=1e-3)[0]
    return space, start, far, scene


def test_a_level_way_leans_nothing_where_the_straight_line_does(model, between):
    space, start, far, scene = between
    straight = PolynomialCurve(np.array([start, far]))

    way = level_way(model, space, (start, far), scene)

    assert leaned_rad(model, space, straight, scene) > 0.07
    assert way is not None
    assert leaned_rad(model, space, way, scene) < 0.02
    np.testing.assert_allclose(way(np.array([0.0, 1.0])), [start, far], atol=1e-9)


def test_what_both_ends_lean_the_way_between_them_leans_no_more(model, between):
    space, start, far, scene = between
    leaned = start.copy()
    leaned[space.index(ROLL)] += 0.3

    way = level_way(model, space, (leaned, far), scene)

    assert way is not None
    assert leaned_rad(model, space, way, scene) < 0.02
    up = [
        model.frame_pose(q, model.description.tcp_frames["right"])[2, :3]
        @ scene.attached["cup"].frame_T_object[:3, 2]
        for q in space.to_q(way(np.array([0.0, 0.5])))[0]
    ]
    first_rad, middle_rad = np.arccos(up)
    assert middle_rad == pytest.approx(0.5 * first_rad, rel=0.1)


@pytest.mark.parametrize("free", [True, False])
def test_the_level_way_is_taken_where_it_is_free(model, between, free):
    space, start, far, scene = between
    straight = PolynomialCurve(np.array([start, far]))
    planner = SimpleNamespace(curve_is_free=lambda _: free)

    lean_rad, way = least_leaning(planner, model, space, straight, scene)

    assert (way is not straight) == free
    assert lean_rad == leaned_rad(model, space, way, scene)
