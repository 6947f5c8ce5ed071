"""Motors on the robot's end of a wire: commands come late, some are lost, and each motor follows its own."""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from typing import Protocol

import numpy as np

from kinematics.arrays import Array
from robots.unitree.layout import Record
from robots.unitree.motors import Motors

SERVO = ("q", "dq", "tau", "kp", "kd")
_FORGOTTEN_S = 0.1


class End(Protocol):
    """The robot's end of a wire."""

    def send(self, message: Record) -> None:
        """Send a state."""
        ...

    def received(self) -> list[Record]:
        """Commands that have come."""
        ...


class PlayedMotors:
    """The motors that one kind of message is about: of the body, or of a hand.

    Attributes:
        columns: Where they are among the robot's actuated joints, shape (n,).
        slots: Where they are in a message, shape (n,).
        jump_rad: The largest step between the positions of two commands that were followed with stiffness.
        stiff: Whether the last command asked for stiffness.
    """

    def __init__(
        self,
        end: End,
        columns: Sequence[int],
        slots: Motors,
        enabled: tuple[int, int],
        *,
        late: int,
        loss: float,
        rng: np.random.Generator,
    ) -> None:
        """Wait for commands.

        Args:
            end: The robot's end of the wire.
            columns: As the attribute.
            slots: As the attribute.
            enabled: Which bits of a motor's mode have to be what for it to follow.
            late: Commands and states come so many periods late.
            loss: Share of the messages that is lost, each way.
            rng: Draws which.
        """
        self.columns, self.slots = np.array(columns, dtype=np.intp), slots
        self.jump_rad, self.stiff = 0.0, False
        self._end, self._enabled, self._loss, self._rng = end, enabled, loss, rng
        self._coming: deque[list[Record]] = deque([[] for _ in range(late)])
        self._going: deque[Record | None] = deque([None] * late)
        self._command: Record | None = None
        self._commanded_s, self._followed = 0.0, np.zeros(len(slots))

    def commands(self) -> list[Record]:
        """What comes in this period."""
        self._coming.append([one for one in self._end.received() if self._rng.random() >= self._loss])
        return self._coming.popleft()

    def take(self, command: Record, t_s: float) -> None:
        """Follow a command from now on."""
        motor = command["motor"][self.slots]
        stiff, was = bool((motor["kp"] > 0.0).any()), self.stiff
        q = motor["q"].astype(np.float64)
        if stiff and was:
            self.jump_rad = max(self.jump_rad, float(np.abs(q - self._followed).max()))
        self._command, self._commanded_s, self._followed, self.stiff = command, t_s, q, stiff

    def servo(self, t_s: float) -> Array:
        """Position, speed, effort, stiffness and damping that they follow now, shape (5, n).

        All are zero when no command has come for 0.1 s.
        """
        if self._command is None or t_s - self._commanded_s > _FORGOTTEN_S:
            return np.zeros((len(SERVO), len(self.slots)))
        motor = self._command["motor"][self.slots]
        bits, value = self._enabled
        on = (motor["mode"] & bits) == value
        return np.array([np.where(on, motor[key], 0.0) for key in SERVO], dtype=np.float64)

    def tell(self, state: Record | None) -> None:
        """Send a state, late, unless it is lost; None says nothing."""
        self._going.append(state)
        sent = self._going.popleft()
        if sent is not None and self._rng.random() >= self._loss:
            self._end.send(sent)
