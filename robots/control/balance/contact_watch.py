"""Notices when an arm pushes against something that no plan knew of.

The efforts that a motion needs are known from the model; what the motors give beyond them comes from
outside. A stiff arm that goes on pushing would sooner tip the robot over than give way.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from kinematics.arrays import Array
from kinematics.estimation.held_mass import effort_per_kg
from kinematics.model.robot_model import RobotModel
from kinematics.motion.trajectory import HeldLoad
from robots.control.gate.refusal import Limit, Refusal
from robots.control.gate.setpoint_limits import largest_excess

# So many periods in a row: longer than noise, shorter than a centimetre of a slow approach.
PERIODS = 5
WALKING_ROOM = 2.0
"""Bounds of a walk, by those of a motion: arms that a walk swings and jolts were seen at 0.9 of those."""
WALKING_PERIODS = 75
"""The same for how long: a lurch, when a sole slips off a plate, is over sooner (28 Nm for 50 ms)."""
# A push that was there before the motion may grow by this: what is picked up has a weight.
GROWTH_NM = 2.0


class ContactWatch:
    """Watches the arms' efforts while planned motions and walks run.

    Args:
        model: The robot.
        allowed_nm: Contact efforts by joint; joints without one are not watched.
    """

    def __init__(self, model: RobotModel, allowed_nm: Mapping[str, float]) -> None:
        self._model = model
        description = model.description
        self._joints = [joint for joint in description.actuated if joint in allowed_nm]
        self._indices = np.array([description.actuated.index(joint) for joint in self._joints], dtype=np.intp)
        self._allowed = np.array([allowed_nm[joint] for joint in self._joints])
        self._bound = self._allowed.copy()
        self._scaled = self._allowed.copy()
        self._outside = np.zeros(len(self._joints))
        self._periods = 0
        self._unweighed: tuple[HeldLoad, ...] = ()
        self._weights: list[tuple[Array, float]] = []

    def bear(self, unweighed: tuple[HeldLoad, ...], reference: Callable[[], Array]) -> None:
        """Expect weights of unknown size in the hands from now on, none beyond the hand's payload.

        Efforts that a weight there explains are no contact: what is picked up is known by its weight only
        after it hangs.

        Args:
            unweighed: What hangs on which frame, and where.
            reference: The configuration now, shape (nq,). It is asked for when what hangs there changes: a
                lift is short, and hardly changes the levers.
        """
        if unweighed == self._unweighed:
            return
        self._unweighed = unweighed
        q = reference() if unweighed else np.empty(0)
        body = [self._model.joints.index(joint) for joint in self._joints]
        grippers = self._model.description.grippers.values()
        payload_kg = {gripper.tcp_frame: gripper.payload_kg for gripper in grippers}
        self._weights = [
            (
                effort_per_kg(self._model, load.frame, q, np.array(load.point_m))[body],
                payload_kg.get(load.frame, 0.0),
            )
            for load in unweighed
        ]

    def judge(self, effort: Array, expected: Array, moving: bool, walks: bool = False) -> Refusal | None:
        """Judge one period.

        Args:
            effort: Measured efforts of the actuated joints, Nm, shape (n,).
            expected: What the motion needs, Nm, shape (n,).
            moving: Whether a planned motion runs; at rest, a push is only noted, so that the motion
                that ends it is not taken for its cause.
            walks: Whether the robot walks: arms swing, and are jolted.

        Returns:
            What pushes too hard, or None.
        """
        outside, bound = self._outside, self._scaled
        if moving and self._weights:
            expected = self._with_weights(effort, expected)
        np.multiply(self._bound, WALKING_ROOM if walks else 1.0, out=bound)
        excess_nm = largest_excess(effort, expected, self._indices, bound, outside)
        if not moving:
            self._bound = np.maximum(self._allowed, outside + GROWTH_NM)
            self._periods = 0
            return None
        self._periods = self._periods + 1 if excess_nm > 0.0 else 0
        if self._periods < (WALKING_PERIODS if walks else PERIODS):
            return None
        self._periods = 0
        worst = int(np.argmax(outside - bound))
        return Refusal(Limit.CONTACT, self._joints[worst], float(outside[worst]), float(bound[worst]))

    def _with_weights(self, effort: Array, expected: Array) -> Array:
        """What is expected when each hand carries the weight that explains most of what is felt."""
        borne = expected.copy()
        for per_kg, payload_kg in self._weights:
            felt = effort[self._indices] - borne[self._indices]
            square = float(per_kg @ per_kg)
            mass_kg = float(np.clip(per_kg @ felt / square, 0.0, payload_kg)) if square > 0.0 else 0.0
            borne[self._indices] += mass_kg * per_kg
        return borne
