"""Feel with a hand that what it holds touches something."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kinematics.estimation.hand_force import HandForce
from kinematics.model.robot_description import Hand
from kinematics.motion.sampler import TrajectorySampler
from kinematics.motion.trajectory import Trajectory
from trees.toolbox import Toolbox

# Of each new reading in the average: about three ticks.
_SHARE = 0.3


class TouchWatch:
    """Feels that what a hand holds touches something, by the averaged force against that at rest.

    It is given one reading each tick.

    Attributes:
        rest_n: Mean force of the readings at rest, shape (3,).
        force_n: The averaged force now, shape (3,).
    """

    def __init__(self, toolbox: Toolbox, hand: Hand) -> None:
        self._toolbox = toolbox
        self._force = HandForce(toolbox.model, hand, toolbox.model.description.joint_viscosity_nms_rad)
        self._sampler: tuple[Trajectory, TrajectorySampler] | None = None
        self._rest: list[NDArray[np.float64]] = []
        self.rest_n = np.zeros(3)
        self.force_n: NDArray[np.float64] | None = None

    def feel_rest(self) -> None:
        """Take one more reading of the hand at rest."""
        self._rest.append(self._reading())
        self.rest_n = np.mean(self._rest, axis=0)
        self.force_n = None

    def feel(self, trajectory: Trajectory | None = None, progress: float = 0.0) -> NDArray[np.float64]:
        """Take one more reading; by how much the averaged force differs from that at rest, shape (3,).

        Args:
            trajectory: The motion under way: its accelerations need efforts that are no force on the hand;
                None at rest.
            progress: Share of it that has passed.
        """
        a = None
        if trajectory is not None:
            if self._sampler is None or self._sampler[0] is not trajectory:
                self._sampler = trajectory, TrajectorySampler(trajectory)
            a = self._sampler[1].at(progress * trajectory.duration_s).a
        new = self._reading(a)
        self.force_n = new if self.force_n is None else self.force_n + _SHARE * (new - self.force_n)
        return np.asarray(self.force_n - self.rest_n)

    def _reading(self, a: NDArray[np.float64] | None = None) -> NDArray[np.float64]:
        state, model = self._toolbox.sensing.state(), self._toolbox.model
        n = len(model.joints)
        v = np.zeros(model.nv)
        v[6:] = state.readings.v[:n]
        a = np.zeros(model.nv) if a is None else a
        return self._force.estimate(state.q, v, a, state.readings.effort[:n])[:3]
