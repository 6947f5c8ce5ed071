"""What the robot knows about itself as one row of numbers, for the state slot, and back."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from kinematics.arrays import Array, Sealed
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import Stance
from robots.interface.gripper_reading import GripperReading
from robots.interface.robot import RobotState
from robots.interface.sensed_state import SensedState
from robots.live.wire.errors import ProtocolError


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
    """

    t_s: float
    resting: bool
    walking: bool
    sensed: SensedState
    reference: Array
    stance: Stance
    grippers: dict[Hand, GripperReading]
    ending: bool = False


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
        self._slide = {hand: gripper.slides for hand, gripper in description.grippers.items()}
        sizes = (3, n, n, n, 3, 3, 6 * feet, model.nq, model.nq, 16 * feet, 4 * len(self._hands))
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
        return np.concatenate(parts)

    def report(self, row: Array) -> RobotReport:
        """The report of a row.

        Raises:
            ProtocolError: The row is for another robot.
        """
        if row.shape != (self.count,):
            raise ProtocolError(f"a state of {row.size} numbers; this robot's has {self.count}")
        head, q, v, effort, gyro, accelerometer, wrench, estimate, reference, soles, felt = np.split(
            row, self._ends
        )
        readings = RobotState(float(head[0]), q, v, effort, gyro, accelerometer, wrench.reshape(-1, 6))
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
        )
