"""What every skill's judge watches: falls, contacts, balance, and what moved that should not."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterable

import numpy as np

from kinematics.geometry.poses import Transform
from robots.simulated.truth.truth import SimulatorTruth

# Falling and balance change slowly: looked at every 10 ms. Contacts are looked at each period.
_EVERY = 5
_HAND_PARTS = ("/upper", "/lower", "/hand")
MOVED_M = 0.01
TIPPED_RAD = math.radians(10.0)


class SafetyWatch:
    """Called after each control period.

    Attributes:
        fell: Whether the robot fell.
        contacts: Pairs "link and solid" of the robot with furniture and people.
        com_margin_m: Least distance of the CoM's projection to the edge of the support polygon, while it
            stands: who walks falls from one foot onto the other.
    """

    def __init__(
        self, truth: SimulatorTruth, walks: Callable[[], bool], fingers: Collection[str], opened: str
    ) -> None:
        """Begin to watch.

        Args:
            truth: The simulator's.
            walks: Whether a walk is under way.
            fingers: Links of the robot that take hold of things.
            opened: Piece whose doors and drawers they may touch; empty where there is none.
        """
        self._truth, self._walks = truth, walks
        self._fingers, self._opened = frozenset(fingers), f"{opened}/" if opened else ""
        self._periods = 0
        self.fell = False
        self.contacts: set[str] = set()
        self.com_margin_m = math.inf

    def on_period(self) -> None:
        """Look at the world."""
        if self._truth.contacts.robot_touches_something():
            for contact in (
                *self._truth.contacts.robot_with_furniture(),
                *self._truth.contacts.robot_with_people(),
            ):
                if contact.second.endswith(_HAND_PARTS):
                    continue  # a person's hand moves by itself
                if self._is_at_handle(contact.first, contact.second):
                    continue
                self.contacts.add(f"{contact.first} and {contact.second}")
        if self._periods % _EVERY == 0:
            self.fell = self.fell or self._truth.fallen()
            if not self._walks():
                self.com_margin_m = min(self.com_margin_m, self._truth.com_margin_m())
        self._periods += 1

    def _is_at_handle(self, link: str, solid: str) -> bool:
        """Whether fingers touch the door or drawer of what is opened: "cabinet/top drawer/front"."""
        opened = bool(self._opened) and solid.startswith(self._opened) and solid.count("/") > 1
        return opened and link in self._fingers


class Bystanders:
    """Where things stood that nobody was asked to touch."""

    def __init__(self, truth: SimulatorTruth, touched: Iterable[str]) -> None:
        self._truth = truth
        left_alone = [name for name in truth.objects() if name not in set(touched)]
        self._stood: dict[str, Transform] = {name: truth.world_T_object(name) for name in left_alone}

    def moved(self) -> dict[str, float]:
        """By how much each has moved, m, that moved or tipped by more than is nothing."""
        found = {}
        for name, before in self._stood.items():
            now = self._truth.world_T_object(name)
            far = float(np.linalg.norm(now[:3, 3] - before[:3, 3]))
            if far > MOVED_M or self._truth.tilt_rad(name) > TIPPED_RAD:
                found[name] = far
        return found
