"""A hand is drawn back no farther than the body's balance allows."""

from dataclasses import replace

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import Stance, stance_at
from kinematics.model.standing_robot import StandingRobot
from kinematics.model.support_polygon import SupportPolygon
from kinematics.planning.retreat_planner import plan_retreat
from kinematics.requests.move import MovePlan, RetreatRequest
from kinematics.requests.step import NoPlan
from kinematics.scene.planning_scene import PlanningScene
from kinematics.standing.free_coordinates import free_coordinates
from robots.models.description import load_description

BESIDE_A_DOOR = [
    -0.0429, 0.0322, 0.8895, -0.0314, 0.0249, -0.0486, -0.0353, 0.0479,
    0.314, 1.0813, 0.2948, -1.1291, 0.8387, -1.3601, -0.2001,
    -0.42, -0.45, -0.6, -1.7, -0.71, 0.55, 0.0, 0.5763, 0.5045,
]  # fmt: skip
"""Free coordinates after a door was opened: the left wrist is at its limit."""
AWAY_M = (-0.0527, 0.1078, 0.0)


@pytest.fixture(scope="module")
def model():
    return RobotModel(load_description("talos"))


def request(model, **wishes):
    stance = Stance(
        tuple(
            (f"{side}_sole_link", poses.translation(0.0, y, 0.0))
            for side, y in (("left", 0.085), ("right", -0.085))
        )
    )
    q, _ = free_coordinates(StandingRobot(model, stance)).to_q(np.array([BESIDE_A_DOOR]))
    return RetreatRequest(q[0], stance, PlanningScene(), "left", AWAY_M, **wishes)


def least_margin_m(model, asked, plan):
    polygon = SupportPolygon(asked.stance, model.description.soles)
    return min(polygon.com_margin_m(model.com(q)) for q in plan.step.trajectory.q)


def test_a_hand_that_may_turn_or_stop_short_leaves_the_robot_in_balance(model):
    asked = request(model, steady_m=0.075, shares=(1.0, 0.6), turns_rad=(0.0, 0.5, -0.5))

    plan = plan_retreat(model, asked)

    assert isinstance(plan, MovePlan)
    assert least_margin_m(model, asked, plan) >= 0.07


def test_a_retreat_that_would_bring_the_robot_off_balance_is_not_made(model):
    insisting = request(model, steady_m=0.075)

    plan = plan_retreat(model, insisting)

    assert isinstance(plan, NoPlan)
    assert "balance" in plan.reasons
    assert plan.numbers["com_margin_m"] < 0.065


def test_where_joints_are_near_their_limits_the_way_does_not_swing_beyond_them(model):
    rng = np.random.default_rng(3)
    space = free_coordinates(StandingRobot(model, request(model).stance))
    at = model.indices(space.joints)
    for _ in range(50):
        x = np.array(BESIDE_A_DOOR)
        x[13] = -rng.uniform(1.0, 1.3699)
        x[8:13] += rng.uniform(-0.3, 0.3, 5)
        x[6:] = np.clip(x[6:], model.lower_rad[at] + 1e-4, model.upper_rad[at] - 1e-4)
        asked = request(model)
        q_start = space.to_q(x[None])[0][0]
        away_m = tuple(rng.uniform(-0.15, 0.15, 3).tolist())

        plan = plan_retreat(model, replace(asked, q_start=q_start, world_offset_m=away_m))

        joints = plan.step.trajectory.q[:, 7:]
        assert (joints >= model.lower_rad).all()
        assert (joints <= model.upper_rad).all()


NEARLY_STRETCHED = [
    0.0177, 0.0019, 0.7624, -0.1601, 0.5126, 0.1213, -0.0975, 0.1746, -0.48,
    -0.684, 0.4014, 0.2565, 1.0647, -0.1571, 0.0324, -0.1077,
    1.1618, -0.3526, -0.2137, -0.5558, -0.0047, 0.0829, -0.0481,
]  # fmt: skip
"""Free coordinates of G1 holding a bottle over a low table, to the left: the right knee is at 0.03 rad."""


def test_a_hand_goes_on_where_a_leg_is_nearly_stretched():
    small = RobotModel(load_description("g1"))
    stance = stance_at(small, small.q_home)
    q, _ = free_coordinates(StandingRobot(small, stance)).to_q(np.array([NEARLY_STRETCHED]))

    plan = plan_retreat(small, RetreatRequest(q[0], stance, PlanningScene(), "left", (0.0, 0.0, -0.008)))

    assert isinstance(plan, MovePlan), str(plan)
    knees = [7 + small.joints.index(f"{side}_knee_joint") for side in ("left", "right")]
    assert plan.step.trajectory.q[-1, knees].min() > 0.09
