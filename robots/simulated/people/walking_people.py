"""The people of a scene who walk about, each along a way of its own or behind the robot."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

from robots.scenes.scene_description import Person
from robots.simulated.body.geom_roles import in_simulator
from robots.simulated.body.physics import Physics
from robots.simulated.people.standing import Standing
from robots.simulated.people.trailing_person import TrailingPerson

_GONE = Standing(500.0, 500.0, 0.0)
"""Where somebody is who has left the scene: farther away than any sensor reaches."""


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


@dataclass(frozen=True, slots=True)
class _Walker:
    person: Person
    mocap: int
    behind: TrailingPerson | None


class WalkingPeople:
    """Moves whoever walks; ``tick`` is called once each control period.

    Attributes:
        stopped_s: Simulated times at which a person, by name, stops for good; evaluations set them.
        gone_s: The same, at which a person leaves the scene for good.
    """

    def __init__(self, physics: Physics) -> None:
        """Move the people of the scene of some physics."""
        self.stopped_s: dict[str, float] = {}
        self.gone_s: dict[str, float] = {}
        self._physics = physics
        self._ticked_s = float(physics.data.time)
        self._walkers: Mapping[str, _Walker] = {
            person.name: _Walker(
                person,
                int(physics.model.body(in_simulator(person.name)).mocapid[0]),
                TrailingPerson(person) if person.follows else None,
            )
            for person in physics.scene.people
            if person.walks
        }

    def tick(self) -> None:
        """Put everybody where they have gone by now."""
        now_s = float(self._physics.data.time)
        for name, walker in self._walkers.items():
            at = self._at(walker, now_s, self.stopped_s.get(name, math.inf))
            if now_s >= self.gone_s.get(name, math.inf):
                at = _GONE
            self._physics.data.mocap_pos[walker.mocap] = (at.x_m, at.y_m, 0.0)
            half = 0.5 * at.yaw_rad
            self._physics.data.mocap_quat[walker.mocap] = (math.cos(half), 0.0, 0.0, math.sin(half))
        self._ticked_s = now_s

    def _at(self, walker: _Walker, now_s: float, stopped_s: float) -> Standing:
        if walker.behind is None:
            return standing_at(walker.person, min(now_s, stopped_s))
        if now_s < stopped_s:
            x, y = self._physics.data.xpos[self._physics.base_body][:2].tolist()
            walker.behind.tick((x, y), now_s - self._ticked_s)
        return walker.behind.at
