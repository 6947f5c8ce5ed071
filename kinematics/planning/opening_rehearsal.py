"""Follow a handle's whole path before anybody touches it, with the tracker that will follow it."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from kinematics.arrays import Array
from kinematics.collision.standing_judge import Kept, StandingJudge
from kinematics.following.hand_tracker import TICK_S, HandGoal, HandTracker
from kinematics.following.opening_motion import (
    BREAK_FREE_N,
    GATHERING,
    HELD_SPIN,
    MOVING_N,
    SPIN_FADES,
    com_shift_m,
    guarded_scene,
    scene_at,
    speed_along,
    turn_along,
)
from kinematics.model.robot_description import Hand
from kinematics.model.standing_robot import StandingRobot
from kinematics.scene.opening_path import OpeningPath
from kinematics.scene.planning_scene import PlanningScene
from kinematics.standing.free_coordinates import free_coordinates

REHEARSED_TICK_S = 0.04
"""Ticks of a rehearsal, four of those that are made: it accepts the same grasps, in a quarter of the time."""
_SETTLE_S = 0.6
_OFF_M, _OFF_COSINE = 0.012, math.cos(math.radians(14.0))
"""A hand that stays behind by more has come to the end of its reach."""
_JUDGED_SHARE = 1.0 / 10.0
"""Of the path between two judgements of collision and balance."""


@dataclass(frozen=True, slots=True)
class Rehearsal:
    """How far a hand led a handle along its path when that was tried out beforehand.

    Attributes:
        farthest_s: The farthest opening, rad or m, that was reached without a fault.
        reason: Why it went no farther; empty when it got to the end.
    """

    farthest_s: float
    reason: str


def rehearse(
    robot: StandingRobot,
    hand: Hand,
    q_grasp: Array,
    scene: PlanningScene,
    parts: tuple[str, ...],
    path: OpeningPath,
    s_from: float,
    s_to: float,
    holding: bool = True,
) -> Rehearsal:
    """Follow a path from a grasp, as ``YieldingHand`` would, and judge the postures on the way.

    Args:
        robot: Where it stands.
        hand: The hand that holds the handle.
        q_grasp: Configuration with the handle in the hand at ``s_from``, shape (nq,).
        scene: What is around; the hand may touch what its ``allowed`` says.
        parts: What moves with the handle.
        path: Of the handle; the hand follows it from where it holds the bar.
        s_from, s_to: Openings.
        holding: Whether the hand holds the handle, and does not only push.
    """
    tick_s = REHEARSED_TICK_S
    tracker = HandTracker(robot, hand, q_grasp, tick_s)
    path = path.through(tracker.tcp_m, s_from)
    space = free_coordinates(robot)
    # what a hand pushes is not as far along its path as the hand: the arm keeps from it what planning keeps
    scene, times = guarded_scene(scene) if holding else scene, np.empty(0)
    rotation, at_z_m = tracker.tcp_rotation.copy(), float(tracker.tcp_m[2])
    axis = path.bar_axis
    own_axis = tracker.tcp_rotation.T @ axis
    way, speed, spin = math.copysign(1.0, s_to - s_from), speed_along(path), HELD_SPIN
    start, turn = path.at(s_from), turn_along(path, robot.model.description, hand, holding)
    shift = com_shift_m(robot, start.outward, at_z_m, BREAK_FREE_N if way > 0.0 else 0.0)
    for _ in range(round(_SETTLE_S / tick_s) if way > 0.0 else 0):
        tracker.tick(HandGoal(start.position_m, rotation, spin, axis, shift), times)
    s, judged_s, steps = s_from, s_from, 0
    step, every = 0.0, _JUDGED_SHARE * (1.0 if holding else 0.5) * abs(s_to - s_from)
    kept: Kept | None = None
    while True:
        if abs(s - judged_s) >= every or s in (s_from, s_to):
            around, x = scene_at(scene, parts, path, s_from, s), space.from_q(tracker.q)
            if kept is None:
                judge = StandingJudge.beginning_at(robot, around, x, tracker.q)
                kept = judge.kept
            else:
                judge = StandingJudge(robot, around, kept)
            found = judge.not_free(x, tracker.q)
            if found is not None:
                blocked = found.pair is not None
                return Rehearsal(judged_s, "something is in the way of the arm" if blocked else str(found))
            judged_s = s
        if s == s_to:
            return Rehearsal(s, "")
        step = min(speed * tick_s, step + GATHERING * speed * tick_s**2)
        s = s_to if abs(s_to - s) <= step else s + way * step
        spin = max(turn.weight, spin * SPIN_FADES ** (tick_s / TICK_S))
        point = path.at(s)
        eased = com_shift_m(robot, point.outward, at_z_m, MOVING_N if way > 0.0 else 0.0)
        steps += 1
        tracker.tick(
            HandGoal(point.position_m, turn.rotation(path, rotation, s_from, s), spin, axis, eased), times
        )
        off_m = float(np.linalg.norm(tracker.tcp_m - point.position_m))
        if off_m > _OFF_M or (tracker.tcp_rotation @ own_axis) @ axis < _OFF_COSINE or not tracker.standing:
            return Rehearsal(judged_s, "the arm does not reach farther")
