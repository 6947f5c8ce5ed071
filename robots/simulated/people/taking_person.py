"""A simulated person who takes what a robot's hand offers: reaches for it, closes the fingers, pulls.

Who is offered something more lays down what is in the hand first, on the floor behind.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Literal

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry.shapes import Shape
from robots.simulated.body.physics import Physics
from robots.simulated.people.person_hand import PersonHand
from robots.simulated.people.person_pinch import BEFORE_M, SPARE_M, Pinch, choose_pinch
from robots.simulated.people.person_way import choose_way
from robots.simulated.truth.truth import SimulatorTruth

PULL_N = 14.0
"""How strongly somebody pulls who takes something."""
REACTION_S = 0.7
REACHING_N = 20.0
"""The most that the hand presses with on its way."""
_PULLED_M = 0.40
_SETTLE_S = 0.4
_ASIDE = math.cos(math.radians(45.0))
"""What is farther to the side than this is turned to."""
_NEAR_M, _AT_M = 0.03, 0.01
_HAS_IT_M = 0.15
"""What was carried so far from where it was offered is the person's."""
_BEHIND_M, _BESIDE_M = 0.30, 0.35
"""Where things are laid down, from the middle of the person."""
_DROP_M = 0.02
_CLEAR_M = 0.15
"""So far the open fingers are drawn back from it."""

Stage = Literal["waiting", "reaching", "closing in", "pinching", "pulling", "laying aside"]


class TakingPerson:
    """One person who takes what is held out; ``tick`` is called once each control period.

    Attributes:
        name: Who it is.
        stage: How far the taking is.
        carried_m: How far what was taken has been carried from where it was offered, horizontally.
    """

    def __init__(
        self,
        physics: Physics,
        truth: SimulatorTruth,
        name: str,
        pull_n: float = PULL_N,
        reaction_s: float = REACTION_S,
    ) -> None:
        """Stand there with an empty hand.

        Args:
            physics: The world that the hand is in.
            truth: Where things are in it.
            name: Of a person of the scene.
            pull_n: How strongly the hand pulls.
            reaction_s: Seconds from the offer to the hand's setting out.
        """
        self.name = name
        self.stage: Stage = "waiting"
        self.carried_m = 0.0
        self._truth, self._pull_n, self._reaction_s = truth, pull_n, reaction_s
        person = next(one for one in physics.scene.people if one.name == name)
        self._place = np.array([*person.position_m, 0.0])
        self._facing = np.array([math.cos(person.yaw_rad), math.sin(person.yaw_rad), 0.0])
        self._shapes = {item.name: item.shape for item in physics.scene.objects}
        self._hand = PersonHand(physics, name)
        self._hand.force_n = REACHING_N
        self._object: str | None = None
        self._pinch: Pinch | None = None
        self._by: list[Array] = []
        self._since_s = self._offered_s = 0.0
        self._offered = np.zeros(3)
        self._following: str | None = None

    def offer(self, thing: str, now_s: float) -> None:
        """See that something is offered; what the hand has already is laid aside for it."""
        if self._object is None:
            self._object, self._offered_s = thing, now_s
        elif self.stage == "pulling" and self.carried_m >= _HAS_IT_M and thing != self._object:
            self._following, self.stage, self._since_s = thing, "laying aside", now_s
            self._by = list(self._way_aside(self._object))

    @property
    def offered(self) -> bool:
        """Whether something was offered to it."""
        return self._object is not None

    def tick(self, period_s: float) -> None:
        """Reach, close, pull; lay aside."""
        if self.stage == "laying aside":
            self._lay_aside()
        elif self._object is not None:
            self._take(self._object, self._shapes[self._object])
        self._hand.tick(period_s)

    def distance_m(self, thing: str) -> float:
        """How far away something is, horizontally."""
        return float(np.linalg.norm((self._place - self._truth.world_T_object(thing)[:3, 3])[:2]))

    def _take(self, thing: str, shape: Shape) -> None:
        now_s = self._truth.time_s
        place = self._truth.world_T_object(thing)[:3, 3]
        towards = self._place - place
        towards[2] = 0.0
        towards /= np.linalg.norm(towards)
        if self._pinch is None:
            if now_s >= self._offered_s + self._reaction_s:
                self._turn_to(-towards)
                self._pinch = choose_pinch(self._hand, place, shape, towards)
                before = place + self._pinch.offset_m + BEFORE_M * towards
                self._by = list(choose_way(self._hand, before, self._pinch, towards)[:-1])
                self._hand.roll_rad = self._pinch.roll_rad
                self._hand.open_m = self._pinch.half_m + SPARE_M
                self.stage, self._since_s = "reaching", now_s
            return
        goal = place + self._pinch.offset_m
        if self._by:
            self._hand.move_to(self._by[0])
            if np.linalg.norm(self._hand.place() - self._by[0]) <= _NEAR_M:
                del self._by[0]
        elif self.stage == "reaching":
            self._hand.move_to(goal + BEFORE_M * towards)
            self._next("closing in", now_s, goal + BEFORE_M * towards, _NEAR_M)
        elif self.stage == "closing in":
            self._hand.move_to(goal)
            if self._next("pinching", now_s, goal, _AT_M):
                self._hand.pinching = True
        elif self.stage == "pinching" and now_s >= self._since_s + _SETTLE_S:
            self.stage, self._since_s = "pulling", now_s
            self._hand.force_n = self._pull_n
            self._hand.hold_fast()
            self._offered = place.copy()
            self._hand.move_to(goal + _PULLED_M * towards)
        if self.stage == "pulling":
            self.carried_m = max(self.carried_m, float(np.linalg.norm((place - self._offered)[:2])))

    def _turn_to(self, direction: Array) -> None:
        """Who looks elsewhere turns before the hand sets out."""
        if float(self._facing @ direction) < _ASIDE:
            self._facing = direction
            self._hand.turn_to(direction)

    def _way_aside(self, thing: str) -> Iterator[Array]:
        """Around the person to the floor behind; the hand goes with the thing as it holds it."""
        hand, item = self._hand.place(), self._truth.world_T_object(thing)[:3, 3]
        out = item - self._place
        out[2] = 0.0
        out /= np.linalg.norm(out)
        beside = _BESIDE_M * np.array([out[1], -out[0], 0.0])
        place, up = self._place * (1.0, 1.0, 0.0), np.array([0.0, 0.0, hand[2]])
        yield place + up + beside + _BEHIND_M * out
        yield place + up + beside - _BEHIND_M * out
        low = hand[2] - item[2] + 0.5 * self._shapes[thing].height_m + _DROP_M
        yield place + beside - _BEHIND_M * out + (0.0, 0.0, low)

    def _lay_aside(self) -> None:
        now_s = self._truth.time_s
        if self._by:
            self._hand.move_to(self._by[0])
            rests = self._hand.pinching or now_s >= self._since_s + _SETTLE_S
            if rests and np.linalg.norm(self._hand.place() - self._by[0]) <= _NEAR_M:
                del self._by[0]
                self._since_s = now_s
            return
        if self._hand.pinching:
            self._hand.pinching = False
            self._by = [self._hand.place(), self._hand.place() - _CLEAR_M * self._facing]
            self._since_s = now_s
        elif now_s >= self._since_s + _SETTLE_S:
            self._object, self._pinch, self.stage, self.carried_m = self._following, None, "waiting", 0.0
            self._following, self._offered_s = None, now_s
            self._hand.force_n = REACHING_N
            self._hand.let_loose()

    def _next(self, stage: Stage, now_s: float, goal: Array, within_m: float) -> bool:
        if now_s >= self._since_s + _SETTLE_S and np.linalg.norm(self._hand.place() - goal) <= within_m:
            self.stage, self._since_s = stage, now_s
            return True
        return False
