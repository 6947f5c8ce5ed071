"""Plan a straight retreat of one hand: no farther, and turned as much, as the body's balance asks.

A hand that is drawn sideways past the reach of its arm takes the pelvis along. Where a retreat may be
shorter, or the hand may turn on the way, the first one is taken that leaves the robot well in balance.
"""

from __future__ import annotations

import itertools
from dataclasses import replace

import numpy as np

from kinematics.arrays import Array
from kinematics.collision.relaxed_start import relaxed_at, start_concessions
from kinematics.collision.validity import validity
from kinematics.geometry import poses
from kinematics.ik.solver import LINE_RESERVE_RAD, InverseKinematics, along_line, inverse_kinematics
from kinematics.model.robot_model import RobotModel
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.curves import PolynomialCurve
from kinematics.motion.lead_in import lead_in
from kinematics.planning.path_planner import PathPlanner
from kinematics.planning.planning_task import CARTESIAN_PACE, CARTESIAN_POINTS
from kinematics.requests.move import MovePlan, RetreatRequest
from kinematics.requests.step import NoPlan, PlannedStep
from kinematics.scene.concessions import in_step, with_touching
from kinematics.scene.planning_scene import PlanningScene
from kinematics.standing.free_coordinates import free_coordinates
from kinematics.timing.balanced_timing import time_in_balance

LEAST_STEADY_M = 0.065
"""Where balance was asked for, no retreat is made with less: TALOS, with the CoM 50 mm inside the edge on
paper and the pelvis 10 cm aside, was seen to lift a foot and fall."""

_LOOKS = 33
"""Points of a curve at which limits are looked at."""


def plan_retreat(model: RobotModel, request: RetreatRequest) -> MovePlan | NoPlan:
    """Plan it, or say why there is none."""
    around = with_touching(request.scene, request.concessions)
    scene = relaxed_at(model, around, request.q_start)
    concessions = in_step(request.concessions, "retreat")
    concessions += start_concessions(model, around, scene, request.q_start, "retreat")
    robot = StandingRobot.of(model, request.stance)
    why = NoPlan("the hand cannot be drawn back at all", {"no way": 1})
    for first in range(len(request.shares)):
        found = _configurations(robot, replace(request, shares=request.shares[first:]), scene)
        if isinstance(found, NoPlan):
            return found if first == 0 else why
        curve = PolynomialCurve(found)
        trajectory = time_in_balance(robot, curve, CARTESIAN_PACE)
        if trajectory is not None:
            trajectory = lead_in(trajectory, request.q_start, model.acceleration)
            return MovePlan(PlannedStep("retreat", trajectory, request.scene, concessions))
        why = NoPlan("the legs cannot follow the motion", {"legs cannot follow": 1})
    return why


def _configurations(robot: StandingRobot, request: RetreatRequest, scene: PlanningScene) -> Array | NoPlan:
    """Free coordinates along the way, shape (n, size)."""
    model, space = robot.model, free_coordinates(robot)
    ik = inverse_kinematics(robot, request.hand)
    planner = PathPlanner(model, space, validity(robot, scene))
    ways = list(itertools.product(request.shares, request.turns_rad))
    best: tuple[float, Array] | None = None
    for share, turn_rad in ways:
        q = _line(model, request, ik, share, turn_rad)
        if q is None:
            continue
        x = np.array([space.from_q(row) for row in q])
        for joint in model.description.groups["head"]:
            x[:, space.index(joint)] = x[0, space.index(joint)]
        # A single way is left to the checker, which says what is hit; so is the start, where the robot is.
        if len(ways) > 1 and not all(planner.is_free(row) for row in x[1:]):
            continue
        margin_m = min(robot.polygon.com_margin_m(model.com(row)) for row in q[1:])
        if margin_m >= request.steady_m:
            return x
        if best is None or margin_m > best[0]:
            best = (margin_m, x)
    if best is None:
        return NoPlan("the hand cannot be drawn back in a straight line", {"no inverse kinematics": 1})
    if best[0] < min(request.steady_m, LEAST_STEADY_M):
        numbers = {"com_margin_m": best[0]}
        return NoPlan("drawing the hand back would bring the robot off balance", {"balance": 1}, numbers)
    return best[1]


def _line(
    model: RobotModel, request: RetreatRequest, ik: InverseKinematics, share: float, turn_rad: float
) -> Array | None:
    start = model.frame_pose(request.q_start, model.description.grippers[request.hand].tcp_frame)
    end = start.copy()
    end[:3, :3] = poses.rotation_z(turn_rad) @ start[:3, :3]
    end[:3, 3] += share * np.asarray(request.world_offset_m)
    found = along_line(ik, request.q_start, start, end, CARTESIAN_POINTS)
    if found is None or _keeps_limits(model, found):
        return found
    spared = along_line(ik, request.q_start, start, end, CARTESIAN_POINTS, LINE_RESERVE_RAD)
    return found if spared is None else spared


def _keeps_limits(model: RobotModel, q: Array) -> bool:
    """Whether the curve through a few configurations stays between limits; its start may be beyond them."""
    curve = PolynomialCurve(q[:, 7:])(np.linspace(0.0, 1.0, _LOOKS))
    lower, upper = np.minimum(model.lower_rad, q[0, 7:]), np.maximum(model.upper_rad, q[0, 7:])
    return bool((curve >= lower).all() and (curve <= upper).all())
