"""Watches the truth while a door or drawer is moved, and never tells the robot."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kinematics.model.robot_description import SoleDescription
from robots.simulated.truth.truth import SimulatorTruth

_EVERY = 5
_CARRIES_N, _LANDED_S = 20.0, 0.2
"""A sole with less on it steps (the robot weighs 900 N), and stands anew so long after it came down."""


class Footing:
    """Where a sole stands on the floor; one that steps does not slip."""

    def __init__(self, place: NDArray[np.float64]) -> None:
        """It stands.

        Args:
            place: Of the sole, m, shape (3,).
        """
        self._stood: NDArray[np.float64] | None = place[:2].copy()
        self._lifted_s = -np.inf

    def slip_m(self, place: NDArray[np.float64], load_n: float, time_s: float) -> float:
        """How far it has come from where it stood, m; 0 while it steps.

        Args:
            place: Of the sole, m, shape (3,).
            load_n: What presses it onto the floor.
            time_s: Simulated time.
        """
        if load_n < _CARRIES_N:
            self._stood, self._lifted_s = None, time_s
        if self._stood is None:
            if time_s - self._lifted_s < _LANDED_S:
                return 0.0
            self._stood = place[:2].copy()
        return float(np.linalg.norm(place[:2] - self._stood))


class OpeningJudge:
    """Judges one piece of furniture; ``on_period`` is called after each control period.

    Attributes:
        fell: Whether the robot fell.
        peak_force_n: Largest force between the robot and the furniture.
        feet_slip_m: Farthest that a sole slid from where it stood; a foot that was lifted stands anew.
        com_margin_m: Least margin so far.
        touched: Pairs "link and solid" that touched, handles left out.
    """

    def __init__(
        self,
        truth: SimulatorTruth,
        soles: tuple[SoleDescription, ...],
        furniture: str,
        pushing: frozenset[str] = frozenset(),
    ) -> None:
        """Begin to watch.

        Args:
            truth: The simulator's.
            soles: The robot's.
            furniture: Which piece is opened or closed.
            pushing: Links of the robot that may touch its door.
        """
        self._truth, self._soles, self._furniture = truth, soles, furniture
        self._pushing = pushing
        self._footing = [Footing(truth.world_T_link(sole.frame)[:3, 3]) for sole in soles]
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
            self.feet_slip_m = max((self.feet_slip_m, *self._slips_m()))
        self._periods += 1

    def _slips_m(self) -> list[float]:
        truth = self._truth
        loads = {one.first: one.force_n for one in truth.contacts.robot_with_floor()}
        return [
            footing.slip_m(truth.world_T_link(sole.frame)[:3, 3], loads.get(sole.link, 0.0), truth.time_s)
            for sole, footing in zip(self._soles, self._footing, strict=True)
        ]

    @property
    def opening(self) -> float:
        """How far it is open, rad or m."""
        return self._truth.opening(self._furniture)
