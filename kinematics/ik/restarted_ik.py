"""Inverse kinematics of an arm that nothing helps: begun anew elsewhere when one start leads nowhere.

A humanoid's trunk and pelvis give way while an arm is brought to a pose. An arm on a welded base has a few
ways to hold a hand there, elbow up or down, wrist this way or that, and a search finds the one that begins
near it: from its home posture Panda found 17 of 60 random poses at handles, from up to 12 starts 52.
"""

from __future__ import annotations

import math

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry.poses import Transform
from kinematics.ik.placo_ik import PlacoIk
from kinematics.ik.result import DEFAULT_TOLERANCE, IkResult, IkTolerance
from kinematics.model.robot_description import Hand
from kinematics.model.standing_robot import StandingRobot

STARTS = 12
"""At 0.4 ms each."""
_DRAWN = 60
_ROOM_RAD = 0.1
"""Starts stay so far from the joints' limits."""


class RestartedIk:
    """Inverse kinematics of one hand of a welded robot."""

    def __init__(self, robot: StandingRobot, hand: Hand) -> None:
        """Choose starts: random postures of the arm, always the same ones, the more natural first.

        Args:
            robot: Where it is mounted.
            hand: The hand whose TCP is placed.

        Raises:
            MissingPartError: The robot has no such hand.
        """
        self._search = PlacoIk(robot, hand)
        model = robot.model
        joints = model.group(f"{hand}_arm")
        home = robot.q_home
        low, high = model.lower_rad[joints] + _ROOM_RAD, model.upper_rad[joints] - _ROOM_RAD
        drawn = np.random.default_rng(0).uniform(low, high, (_DRAWN, len(joints)))
        nearest = np.argsort(np.linalg.norm(drawn - home[7 + joints], axis=1), kind="stable")
        self._joints, self._starts = joints, drawn[nearest[:STARTS]]

    def solve(
        self,
        world_T_tcp: Transform,
        q_seed: Array,
        tolerance: IkTolerance = DEFAULT_TOLERANCE,
        iterations: int = 60,
        q_preferred: Array | None = None,
        upright: bool = False,
        lowest_m: float = -math.inf,
    ) -> IkResult:
        """Bring the TCP to a pose; what is to stay near a posture begins there alone.

        Args, and what is raised, as of ``PlacoIk.solve``.

        Returns:
            The first answer within the tolerance, else that of the first start.
        """
        first = self._search.solve(world_T_tcp, q_seed, tolerance, iterations, q_preferred, upright, lowest_m)
        if first.within(tolerance) or q_preferred is not None:
            return first
        for start in self._starts:
            q = q_seed.copy()
            q[7 + self._joints] = start
            found = self._search.solve(world_T_tcp, q, tolerance, iterations, None, upright, lowest_m)
            if found.within(tolerance):
                return found
        return first
