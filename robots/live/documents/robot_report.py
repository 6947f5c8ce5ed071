"""What the robot knows about itself as one row of numbers, for the state slot, and back."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from kinematics.arrays import Array, Sealed
from kinematics.geometry.planar import PlanarPose
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import Stance
from robots.interface.gripper_reading import GripperReading
from robots.interface.robot import RobotState
from robots.interface.sensed_state import SensedState
from robots.live.wire.errors import ProtocolError

MOST_LANDINGS = 4


@dataclass(frozen=True, slots=True)
class RobotReport(Sealed):
    """Everything that the commander is told of the robot, at one instant.

    Attributes:
        t_s: Control time.
        resting: Whether nothing moves the body.
        walking: Whether a walk is under way, its last steps included.
        sensed: Readings and estimated configuration.
        reference: Commanded configuration, shape (nq,).
        stance: Where the feet stand.
        grippers: What they feel.
        ending: Whether a walk under way was told to end: what is commanded brakes, step by step.
        landings: The landings that a walk under way plans next, shape (n, 4), at most ``MOST_LANDINGS``: 1
            for the left foot and -1 for the right one, x and y in m, heading in rad, in the odometry frame.
    """

    t_s: float
    resting: bool
    walking: bool
    sensed: SensedState
    reference: Array
    stance: Stance
    grippers: dict[Hand, GripperReading]
    ending: bool = False
    landings: Array = field(default_factory=lambda: np.zeros((0, 4)))


class ReportLayout:
    """Where each number of a report stands in the row; the same on both sides for the same robot.

    Attributes:
        count: How many numbers a row has.
    """

    def __init__(self, model: RobotModel) -> None:
        """Lay out the reports of one robot."""
        description = model.description
        n, feet = len(description.actuated), len(description.soles)
        self._soles = tuple(sole.frame for sole in description.soles)
        self._hands = tuple(description.grippers)
        self._feet_estimated = feet > 0 and not description.foot_sensors
        own = (3, n, n, n, 3, 3, 6 * feet, model.nq, model.nq)
        sizes = (*own, 16 * feet, 4 * len(self._hands), 4 * MOST_LANDINGS)
        self._slide = {hand: gripper.slides for hand, gripper in description.grippers.items()}
        self._ends = np.cumsum(sizes)[:-1]
        self.count = sum(sizes)

    def row(self, report: RobotReport) -> Array:
        """The row of a report, shape (count,).

        Raises:
            ProtocolError: It stands on other soles than the robot has.
        """
        readings, poses = report.sensed.readings, dict(report.stance.soles)
        if tuple(poses) != self._soles:
            raise ProtocolError(f"the report stands on {tuple(poses)}, the robot on {self._soles}")
        head = np.array([report.t_s, float(report.resting), float(report.walking + report.ending)])
        parts = [head, readings.q, readings.v, readings.effort]
        parts += [readings.gyro, readings.accelerometer, readings.foot_wrench.ravel()]
        parts += [report.sensed.q, report.reference, *(poses[frame].ravel() for frame in self._soles)]
        for hand in self._hands:
            felt = report.grippers[hand]
            parts.append(np.array([felt.position_rad, felt.opening_m, felt.effort_nm, float(felt.holding)]))
        ahead = np.zeros((MOST_LANDINGS, 4))
        ahead[: len(report.landings)] = report.landings[:MOST_LANDINGS]
        return np.concatenate([*parts, ahead.ravel()])

    def report(self, row: Array) -> RobotReport:
        """The report of a row.

        Raises:
            ProtocolError: The row is for another robot.
        """
        if row.shape != (self.count,):
            raise ProtocolError(f"a state of {row.size} numbers; this robot's has {self.count}")
        head, q, v, effort, gyro, accelerometer, wrench, estimate, reference, soles, felt, ahead = np.split(
            row, self._ends
        )
        landings = ahead.reshape(-1, 4)
        felt_feet = wrench.reshape(-1, 6)
        readings = RobotState(
            float(head[0]),
            q,
            v,
            effort,
            gyro,
            accelerometer,
            felt_feet,
            feet_estimated=self._feet_estimated,
        )
        poses = soles.reshape(-1, 4, 4)
        grippers = {
            hand: GripperReading(hand, float(p), float(opening), float(nm), bool(holding), self._slide[hand])
            for hand, (p, opening, nm, holding) in zip(self._hands, felt.reshape(-1, 4), strict=True)
        }
        return RobotReport(
            t_s=float(head[0]),
            resting=bool(head[1]),
            walking=bool(head[2]),
            sensed=SensedState(readings, estimate.copy),
            reference=reference,
            stance=Stance(tuple(zip(self._soles, poses, strict=True))),
            grippers=grippers,
            ending=bool(head[2] > 1.0),
            landings=landings[landings[:, 0] != 0.0],
        )


def landings_of(planned: Sequence[tuple[Hand, PlanarPose]]) -> Array:
    """Landings as a report has them, shape (n, 4), from which foot, and where; the first ones of many."""
    rows = [
        (1.0 if side == "left" else -1.0, pose.x_m, pose.y_m, pose.yaw_rad)
        for side, pose in planned[:MOST_LANDINGS]
    ]
    return np.array(rows).reshape(-1, 4)
