"""What a yielding hand is asked for: everything but the robot that it belongs to."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Literal

from kinematics.arrays import Array, Sealed
from kinematics.model.robot_description import Hand
from kinematics.scene.opening_path import OpeningPath
from kinematics.scene.planning_scene import PlanningScene
from robots.control.hands.yield_settings import USUAL, YieldSettings

Manner = Literal["usual", "gentle"]

GENTLE = replace(USUAL, stop_force_n=20.0, eased_n=6.0, stuck_s=0.1, slow_share=0.5, ease_m=0.014)
"""Fingers that meet a door behind its bar press no harder than a hand that knocks, and leave room for
their own closing: fingertips swing ahead by a centimetre."""

MANNERS: Mapping[Manner, YieldSettings] = MappingProxyType({"usual": USUAL, "gentle": GENTLE})
"""Forces belong to the control side: who orders a motion chooses among these, and sets no number."""


@dataclass(frozen=True, slots=True)
class YieldOrder(Sealed):
    """A hand that leads along a path from where it is commanded now, and yields across it.

    Attributes:
        hand: Which.
        scene: What is around at ``s_from``; the hand may touch what its ``allowed`` says.
        parts: What of the scene moves with the handle.
        path: Of the TCP, in the odometry frame: ``path.at(s_from)`` is where it is.
        s_from, s_to: Where along it to lead; equal to stay and yield until ``finish``.
        bias: Of the force estimate, shape (6,); measured at the start when left out.
        stop_from: What stands still nearer to ``s_to`` than this has met its stop, and is not stuck.
        holding: Whether the hand holds something that it can lose.
        manner: How it yields.
    """

    hand: Hand
    scene: PlanningScene
    parts: tuple[str, ...]
    path: OpeningPath
    s_from: float
    s_to: float
    bias: Array | None = None
    stop_from: float | None = None
    holding: bool = True
    manner: Manner = "usual"
