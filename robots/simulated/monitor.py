"""Watch a simulated world each control period and remember what an evaluation asks for at the end."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from kinematics import poses
from kinematics.poses import Transform
from kinematics.robot_description import Hand
from robots.simulated.truth import SimulatorTruth, TrueContact

BALANCE_EVERY = 5
"""Periods from one look at the balance to the next: bodies of this mass do not fall in 10 ms."""
LIFTED_OFF_M = 0.005
"""An object this far above what is under it, touched by finger pads alone, is held."""


@dataclass(slots=True)
class HoldRecord:
    """One hold of one object, from leaving the ground to its end.

    Attributes:
        hand: Whose pads.
        since_s: When it left the ground.
        until_s: The last instant at which it was held.
        raised_s: Since when it has been above the monitor's height without a break; None while it is not.
        slip_m: Largest distance from where it was in the TCP frame at the beginning.
        slip_rad: Largest turn from there.
        lift_m: Height of its lowest point above what is under it, at ``until_s``.
        tcp_T_object: Pose in the TCP frame at the beginning, shape (4, 4).
    """

    hand: Hand
    since_s: float
    until_s: float
    raised_s: float | None
    slip_m: float
    slip_rad: float
    lift_m: float
    tcp_T_object: Transform


class Monitor:
    """What happened in a world, judged by its truth.

    Args:
        truth: Of the world to watch.
        lift_m: Height from which an object counts as lifted, above what is under it.

    Attributes:
        furniture_contacts: Largest force in N of each pair (robot link, furniture solid) that touched.
        people_contacts: The same with persons.
        object_contacts: The same of links that are no finger pads with objects.
        min_com_margin_m: Least distance of the CoM to the edge of the support polygon.
        fell_at_s: When the robot fell, or None.
        holds: Every hold of each object, in order.
    """

    def __init__(self, truth: SimulatorTruth, lift_m: float = 0.10) -> None:
        self._truth, self._lift_m = truth, lift_m
        self.furniture_contacts: dict[tuple[str, str], float] = {}
        self.people_contacts: dict[tuple[str, str], float] = {}
        self.object_contacts: dict[tuple[str, str], float] = {}
        self.min_com_margin_m = math.inf
        self.fell_at_s: float | None = None
        self.holds: dict[str, list[HoldRecord]] = {}
        self._held_now: set[str] = set()
        self._ticks = 0

    def tick(self) -> None:
        """Look at the world; call it once after each control period."""
        truth = self._truth
        if truth.robot_touches_something():
            _keep_largest(self.furniture_contacts, truth.contacts_with_furniture())
            _keep_largest(self.people_contacts, truth.contacts_with_people())
            _keep_largest(self.object_contacts, truth.contacts_with_objects())
            self._watch_holds()
        else:
            self._held_now.clear()
        self._ticks += 1
        if self._ticks % BALANCE_EVERY:
            return
        self.min_com_margin_m = min(self.min_com_margin_m, truth.com_margin_m())
        if self.fell_at_s is None and truth.fallen():
            self.fell_at_s = truth.time_s

    def held_for_s(self, name: str) -> float:
        """How long an object has been held without a break until now; 0 when it is not held."""
        return self._truth.time_s - self.holds[name][-1].since_s if name in self._held_now else 0.0

    def lifted_for_s(self, name: str) -> float:
        """How long an object has been held at least ``lift_m`` high without a break until now."""
        raised_s = self.holds[name][-1].raised_s if name in self._held_now else None
        return 0.0 if raised_s is None else self._truth.time_s - raised_s

    def max_slip_m(self, name: str) -> float:
        """Largest slip of an object in any of its holds; 0 when it was never held."""
        return max((record.slip_m for record in self.holds.get(name, [])), default=0.0)

    def _watch_holds(self) -> None:
        truth, now = self._truth, self._truth.time_s
        held = {
            name: hand for name, hand in truth.in_pads_only().items() if truth.lift_m(name) > LIFTED_OFF_M
        }
        for name, hand in held.items():
            tcp_T_object, records = truth.tcp_T_object(hand, name), self.holds.setdefault(name, [])
            if name not in self._held_now or records[-1].hand != hand:
                records.append(HoldRecord(hand, now, now, None, 0.0, 0.0, 0.0, tcp_T_object))
            record = records[-1]
            moved = tcp_T_object[:3, 3] - record.tcp_T_object[:3, 3]
            record.slip_m = max(record.slip_m, float(np.linalg.norm(moved)))
            turn = poses.angle_between(record.tcp_T_object[:3, :3], tcp_T_object[:3, :3])
            record.slip_rad = max(record.slip_rad, turn)
            record.until_s, record.lift_m = now, truth.lift_m(name)
            if record.lift_m < self._lift_m:
                record.raised_s = None
            elif record.raised_s is None:
                record.raised_s = now
        self._held_now = set(held)


def _keep_largest(record: dict[tuple[str, str], float], contacts: Iterable[TrueContact]) -> None:
    for contact in contacts:
        key = (contact.first, contact.second)
        record[key] = max(record.get(key, 0.0), contact.force_n)
