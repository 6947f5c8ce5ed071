"""Watches the truth while a door or drawer is moved, and never tells the robot."""

from __future__ import annotations

import numpy as np

from robots.simulated.truth import SimulatorTruth

_EVERY = 5


class OpeningJudge:
    """Judges one piece of furniture; ``on_period`` is called after each control period.

    Attributes:
        fell: Whether the robot fell.
        peak_force_n: Largest force between the robot and the furniture.
        feet_slip_m: Farthest that a sole came from where it stood.
        com_margin_m: Least margin so far.
        touched: Pairs "link and solid" that touched, handles left out.
    """

    def __init__(
        self,
        truth: SimulatorTruth,
        soles: tuple[str, ...],
        furniture: str,
        pushing: frozenset[str] = frozenset(),
    ) -> None:
        """Begin to watch.

        Args:
            truth: The simulator's.
            soles: Frames of the soles.
            furniture: Which piece is opened or closed.
            pushing: Links of the robot that may touch its door.
        """
        self._truth, self._soles, self._furniture = truth, soles, furniture
        self._pushing = pushing
        self._stood = [truth.world_T_link(sole)[:3, 3].copy() for sole in soles]
        self._periods = 0
        self.fell = False
        self.peak_force_n = 0.0
        self.feet_slip_m = 0.0
        self.com_margin_m = float("inf")
        self.touched: set[str] = set()

    def on_period(self) -> None:
        """Look at the world."""
        force_n = float(np.linalg.norm(self._truth.contacts.furniture_force_on_robot()))
        self.peak_force_n = max(self.peak_force_n, force_n)
        for contact in self._truth.contacts.robot_with_furniture():
            if contact.first in self._pushing and contact.second.endswith("/door"):
                continue
            self.touched.add(f"{contact.first} and {contact.second}")
        if self._periods % _EVERY == 0:
            self.fell = self.fell or self._truth.fallen()
            self.com_margin_m = min(self.com_margin_m, self._truth.com_margin_m())
            slips = [
                float(np.linalg.norm(self._truth.world_T_link(sole)[:2, 3] - stood[:2]))
                for sole, stood in zip(self._soles, self._stood, strict=True)
            ]
            self.feet_slip_m = max(self.feet_slip_m, *slips)
        self._periods += 1

    @property
    def opening(self) -> float:
        """How far it is open, rad or m."""
        return self._truth.opening(self._furniture)
