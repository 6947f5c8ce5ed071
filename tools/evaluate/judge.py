"""The judge of an episode: watches the simulator's truth beside the run and never tells the robot."""

from __future__ import annotations

import math
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from kinematics.geometry.poses import Transform
from kinematics.model.robot_description import Hand
from robots.simulated.truth.true_contacts import PadContact, TrueContact

LIFTED_M = 0.10
HELD_S = 2.0
# Clear of the furniture by this, it is in the hand and nowhere else.
_IN_HAND_M = 0.01
# From the TCP to the centre of something that is held, at most.
_NEAR_HAND_M = 0.12
# Falling, balance and slip change slowly: looked at every 10 ms. Contacts are looked at each period.
_EVERY = 5


class Contacts(Protocol):
    """What a judge asks about contacts."""

    def of_pads(self, name: str) -> tuple[PadContact, ...]:
        """Contact points of the finger pads with an object."""
        ...

    def robot_touches_something(self) -> bool:
        """Whether the robot touches anything but the floor."""
        ...

    def robot_with_furniture(self) -> tuple[TrueContact, ...]:
        """What of the robot touches furniture."""
        ...

    def robot_with_objects(self) -> tuple[TrueContact, ...]:
        """What of the robot touches objects."""
        ...


class Truth(Protocol):
    """What a judge looks at."""

    def objects(self) -> tuple[str, ...]:
        """Names of the objects that are in the world."""
        ...

    def lift_m(self, name: str) -> float:
        """Height of an object above the furniture under it."""
        ...

    def tcp_T_object(self, hand: Hand, name: str) -> Transform:
        """Pose of an object in a hand."""
        ...

    @property
    def contacts(self) -> Contacts:
        """What touches what."""
        ...

    def com_margin_m(self) -> float:
        """Distance of the CoM's projection to the edge of the support polygon."""
        ...

    @property
    def hands(self) -> tuple[Hand, ...]:
        """The hands that can hold something."""
        ...

    def fallen(self) -> bool:
        """Whether the robot lies or is falling."""
        ...


class Judge:
    """Judges one object's pick; ``on_period`` is called after each control period.

    Attributes:
        fell: Whether the robot fell.
        furniture_contacts: Pairs "link and solid" that touched.
        others_touched: Pairs "link and object" that touched; the target is left out.
        com_margin_m: Least margin so far.
        slip_m: Farthest motion of the object in the hand while it was lifted, or None.
        friction: Lowest friction of a pad contact while lifted, as the simulator used it, or None.
        held_lift_m: Least height since ``begin_hold``.
    """

    def __init__(self, truth: Truth, target: str) -> None:
        self._truth, self._target = truth, target
        self._periods = 0
        self._reference: tuple[Hand, NDArray[np.float64]] | None = None
        self._holding = False
        self.fell = False
        self.furniture_contacts: set[str] = set()
        self.others_touched: set[str] = set()
        self.com_margin_m = math.inf
        self.slip_m: float | None = None
        self.friction: float | None = None
        self.held_lift_m = math.inf

    def on_period(self) -> None:
        """Look at the world."""
        if self._truth.contacts.robot_touches_something():
            self._note_contacts()
        if self._periods % _EVERY == 0:
            self.fell = self.fell or self._truth.fallen()
            self.com_margin_m = min(self.com_margin_m, self._truth.com_margin_m())
            self._watch_object()
        self._periods += 1

    def _note_contacts(self) -> None:
        for contact in self._truth.contacts.robot_with_furniture():
            self.furniture_contacts.add(f"{contact.first} and {contact.second}")
        for contact in self._truth.contacts.robot_with_objects():
            if contact.second != self._target:
                self.others_touched.add(f"{contact.first} and {contact.second}")

    def begin_hold(self) -> None:
        """From now on the object has to stay up."""
        self._holding = True
        self._watch_object()

    @property
    def truly_held(self) -> bool:
        """Whether the object was high enough ever since ``begin_hold``, and the robot stands."""
        return self._holding and LIFTED_M <= self.held_lift_m < math.inf and not self.fell

    def _watch_object(self) -> None:
        present = self._target in self._truth.objects()
        height = self._truth.lift_m(self._target) if present else 0.0
        if self._holding:
            self.held_lift_m = min(self.held_lift_m, height)
        if height < _IN_HAND_M:
            self._reference = None
            return
        if self._reference is None:
            self._reference = self._nearest_hand()
        if self._reference is not None:
            hand, start = self._reference
            moved = float(np.linalg.norm(self._truth.tcp_T_object(hand, self._target)[:3, 3] - start))
            self.slip_m = max(self.slip_m or 0.0, moved)
            contacts = self._truth.contacts.of_pads(self._target)
            frictions = [contact.friction for contact in contacts]
            if frictions:
                self.friction = min(frictions) if self.friction is None else min(self.friction, *frictions)

    def _nearest_hand(self) -> tuple[Hand, NDArray[np.float64]] | None:
        places = [(hand, self._truth.tcp_T_object(hand, self._target)[:3, 3]) for hand in self._truth.hands]
        hand, place = min(places, key=lambda item: float(np.linalg.norm(item[1])))
        return (hand, place) if float(np.linalg.norm(place)) <= _NEAR_HAND_M else None
