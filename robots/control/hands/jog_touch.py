"""What an arm that a person jogs presses against although nobody has seen it, felt in its efforts.

The motors give what the motion needs, which the model knows, and what something outside takes. Jogging is
slow and gentle, so that little of the difference is its own: of a free arm at most an eighth of what means
contact was seen. Whatever turns the joints along with what they give beyond the need presses on; the way
back gives work back, and so the two are told apart. A hand that was stopped by something gives way until it
hardly presses.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from kinematics.arrays import Array
from kinematics.estimation.held_mass import effort_per_kg
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel
from robots.interface.hardware import Hardware

_SHARE = 0.5
"""Of the effort that means contact where arms move as planned."""
_TICKS = 2
"""So many in a row: 20 ms, 2.4 mm of the fastest approach."""
_LIGHT = 0.4
"""Of that: it gives way until no joint gives more."""
_EASED_S = 0.25
"""Time constant of giving way; what is told is a mean over 0.07 s, which this has to be slow beside."""
_LEAST_WORK = 0.05
"""Of the work that all joints together would do, one way or the other: less is neither to nor fro."""


class JogTouch:
    """Adds up what the arms' motors give beyond the need, and tells what presses.

    Args:
        model: The robot.
        hardware: By joint, what means contact, and the servos' stiffness; joints without are not judged.
        holds: Whether a hand's fingers hold something: its weight is no contact.

    Attributes:
        felt_nm: What is felt beyond the need, by body joint, shape (n,), while that is a touch, or None.
        told: The same for people; empty when nothing is felt.
        easing: Rates of the body joints that give way to it, shape (n,), rad/s.
    """

    def __init__(self, model: RobotModel, hardware: Hardware, holds: Callable[[Hand], bool]) -> None:
        allowed_nm = hardware.contact_effort_nm
        self._model, self._holds = model, holds
        groups = model.description.groups
        joints = [joint for joint in model.joints if joint in allowed_nm]
        self._arms = {hand: set(groups.get(f"{hand}_arm", ())) for hand in model.description.tcp_frames}
        self._judged = model.indices(joints)
        self._bound = _SHARE * np.array([allowed_nm[joint] for joint in joints])
        self._stiffness = np.array([hardware.gains[joint].stiffness for joint in joints])
        self._counting = model.indices([*joints, *groups.get("torso", ())])
        self._sum, self._count, self._ticks = np.zeros(len(model.joints)), 0, 0
        self.felt_nm: Array | None = None
        self.told = ""
        self.easing = np.zeros(len(model.joints))

    def begin(self) -> None:
        """Forget what was felt."""
        self._sum[:] = 0.0
        self._count = self._ticks = 0
        self.felt_nm, self.told = None, ""
        self.easing[:] = 0.0

    def take(self, effort: Array, needed: Array) -> None:
        """Take one control period in.

        Args:
            effort, needed: Of the actuated joints, body joints first, as measured and as needed, Nm.
        """
        bodies = len(self._sum)
        self._sum += effort[:bodies]
        self._sum -= needed[:bodies]
        self._count += 1

    def tick(self, q: Array) -> None:
        """Judge what was taken in since the last tick.

        Args:
            q: Configuration, shape (nq,).
        """
        if self._count == 0:
            return
        outside = self._sum / self._count
        self._sum[:] = 0.0
        self._count = 0
        self._take_weights_off(outside, q)
        judged = outside[self._judged]
        too_much = np.sign(judged) * np.maximum(np.abs(judged) - _LIGHT * self._bound, 0.0)
        self.easing[self._judged] = -too_much / (self._stiffness * _EASED_S)
        beyond = np.abs(judged) - self._bound
        worst = int(np.argmax(beyond)) if len(beyond) else 0
        self._ticks = self._ticks + 1 if len(beyond) and beyond[worst] > 0.0 else 0
        self.felt_nm, self.told = None, ""
        if self._ticks < _TICKS:
            return
        self.felt_nm = np.zeros_like(outside)
        self.felt_nm[self._counting] = outside[self._counting]
        joint = self._model.joints[int(self._judged[worst])]
        arm = next((hand for hand, joints in self._arms.items() if joint in joints), None)
        whose = "the robot" if arm is None else f"the {arm} arm"
        self.told = (
            f"{whose} meets something that nobody saw ({joint} gives "
            f"{abs(float(judged[worst])):.1f} Nm more than it needs)"
        )

    def presses(self, rates: Array) -> bool:
        """Whether rates of the body joints, shape (n,), press on against what is felt."""
        if self.felt_nm is None:
            return False
        work = self.felt_nm * rates
        return float(work.sum()) > _LEAST_WORK * float(np.abs(work).sum())

    def _take_weights_off(self, outside: Array, q: Array) -> None:
        """Take off what the weight of a held thing explains, none beyond the hand's payload."""
        for hand, gripper in self._model.description.grippers.items():
            if not self._holds(hand):
                continue
            per_kg = effort_per_kg(self._model, gripper.tcp_frame, q, np.zeros(3))
            lever = per_kg[self._judged]
            square = float(lever @ lever)
            mass_kg = float(lever @ outside[self._judged]) / square if square > 0.0 else 0.0
            outside -= min(max(mass_kg, 0.0), gripper.payload_kg) * per_kg
