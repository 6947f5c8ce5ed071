"""What a pick's planner moves, as points of its space and as configurations of Pinocchio's reduced model."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import pinocchio as pin

# How far the pelvis may go from where it is, m and rad.
PELVIS_ROOM = np.array([[-0.15, -0.12, -0.35, -0.3, -0.3, -0.3], [0.15, 0.12, 0.03, 0.3, 0.3, 0.3]])


class TrunkAndArm:
    """Legs and head stay: the joints of trunk and one arm.

    Attributes:
        model, solids: Without the joints that stay.
        home: Of the reduced model.
        lower, upper: Bounds of a point.
    """

    def __init__(self, robot: Any, joints: Sequence[str]) -> None:
        self.model, self.solids = _reduced(robot, joints)
        index = robot.indices(joints)
        margin = robot.description.planning_margin_rad
        self.lower, self.upper = robot.lower_rad[index] + margin, robot.upper_rad[index] - margin
        self._order = np.array([joints.index(name) for name in list(self.model.names)[1:]])
        self.home = robot.q_home[7:][index][self._order]

    def rows(self, points: Any) -> tuple[Any, Any]:
        """Configurations of the reduced model, and which of the points have one; by point, shape (n, 9)."""
        return points[:, self._order], np.ones(len(points), bool)


class WholeBody:
    """Both feet stand: the pelvis's place and rotation vector, then the joints of trunk and one arm.

    No peer solves legs in closed form, so they get the product's own, many points in one call.

    Attributes:
        model, solids, home, lower, upper: As of ``TrunkAndArm``.
    """

    def __init__(self, robot: Any, joints: Sequence[str], stance: Any) -> None:
        from kinematics.model.standing_robot import StandingRobot
        from kinematics.standing.free_coordinates import FreeCoordinates
        from kinematics.standing.leg_ik import LegIk

        groups = robot.description.groups
        legs = [joint for name, members in groups.items() if name.endswith("_leg") for joint in members]
        self.model, self.solids = _reduced(robot, [*legs, *joints, "root_joint"])
        standing = StandingRobot(robot, stance)
        self._legs, self._q_home = LegIk(standing), robot.q_home
        self._columns = 7 + robot.indices(joints)
        kept = list(self.model.names)[2:]
        self._kept = np.concatenate([np.arange(7), 7 + robot.indices(kept)])
        self.home = robot.q_home[self._kept]
        margin = robot.description.planning_margin_rad
        self._lower_rad, self._upper_rad = robot.lower_rad + margin, robot.upper_rad - margin
        place = FreeCoordinates(standing).from_q(robot.q_home)[:6] + PELVIS_ROOM
        index = robot.indices(joints)
        self.lower = np.concatenate([place[0], self._lower_rad[index]])
        self.upper = np.concatenate([place[1], self._upper_rad[index]])

    def rows(self, points: Any) -> tuple[Any, Any]:
        """As of ``TrunkAndArm``, by point, shape (n, 15)."""
        q = np.tile(self._q_home, (len(points), 1))
        q[:, :3], q[:, self._columns] = points[:, :3], points[:, 6:]
        angle = np.sqrt(np.sum(points[:, 3:6] ** 2, axis=1))
        q[:, 3:6] = points[:, 3:6] * (0.5 * np.sinc(0.5 * angle / np.pi))[:, None]
        q[:, 6] = np.cos(0.5 * angle)
        reached = self._legs.fill(q)
        inside = np.all((q[:, 7:] >= self._lower_rad) & (q[:, 7:] <= self._upper_rad), axis=1)
        return np.ascontiguousarray(q[:, self._kept]), reached & inside


def _reduced(robot: Any, kept: Sequence[str]) -> tuple[Any, Any]:
    locked = [k for k in range(1, robot.pin.njoints) if robot.pin.names[k] not in kept]
    model, solids = pin.buildReducedModel(robot.pin, robot.geometry(), locked, robot.q_home)
    return model, solids
