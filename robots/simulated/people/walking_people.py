"""The people of a scene who walk about, each along a way of its own."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

from robots.scenes.scene_description import Person
from robots.simulated.body.geom_roles import in_simulator
from robots.simulated.body.physics import Physics


@dataclass(frozen=True, slots=True)
class Standing:
    """Where a person is: place on the floor in the world frame, m, and heading, rad."""

    x_m: float
    y_m: float
    yaw_rad: float


def standing_at(person: Person, now_s: float) -> Standing:
    """Where a person who walks is at a time; who does not walk is where the scene says.

    The speed is constant, turns are at once, and the walk ends at the last point of the way.

    Args:
        person: With the way.
        now_s: Simulated time.
    """
    x, y = person.position_m
    yaw = person.yaw_rad
    left_m = max(now_s - person.starts_s, 0.0) * person.speed_m_s
    for to_x, to_y in person.way_m:
        if left_m <= 0.0:
            break
        length_m = math.dist((x, y), (to_x, to_y))
        if length_m == 0.0:
            continue
        yaw = math.atan2(to_y - y, to_x - x)
        share = min(left_m / length_m, 1.0)
        x, y, left_m = x + share * (to_x - x), y + share * (to_y - y), left_m - length_m
    return Standing(x, y, yaw)


class WalkingPeople:
    """Moves whoever has a way; ``tick`` is called once each control period.

    Attributes:
        stopped_s: Simulated times at which a person, by name, stops for good; evaluations set them.
    """

    def __init__(self, physics: Physics) -> None:
        """Move the people of the scene of some physics."""
        self.stopped_s: dict[str, float] = {}
        self._physics = physics
        self._bodies: Mapping[str, tuple[Person, int]] = {
            person.name: (person, int(physics.model.body(in_simulator(person.name)).mocapid[0]))
            for person in physics.scene.people
            if person.way_m
        }

    def tick(self) -> None:
        """Put everybody where the way has led by now."""
        now_s = float(self._physics.data.time)
        for name, (person, mocap) in self._bodies.items():
            at = standing_at(person, min(now_s, self.stopped_s.get(name, math.inf)))
            self._physics.data.mocap_pos[mocap] = (at.x_m, at.y_m, 0.0)
            half = 0.5 * at.yaw_rad
            self._physics.data.mocap_quat[mocap] = (math.cos(half), 0.0, 0.0, math.sin(half))
