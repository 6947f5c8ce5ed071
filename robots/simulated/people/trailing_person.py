"""A person who walks behind the robot, along the way that the robot has gone."""

from __future__ import annotations

import math
from collections import deque

from robots.scenes.scene_description import Person
from robots.simulated.people.standing import Standing

BEHIND_M = 1.2
"""So far from the robot the person stays, nearer only where the robot itself comes nearer."""
MET_M = 1.6
"""The person follows a robot that has come so near,"""
_GONE_ON_M = 0.15
"""and then goes away again by so much."""
_CRUMB_M = 0.1
"""Between two places of the robot's way that are remembered."""


class TrailingPerson:
    """Somebody who follows the robot once it has come near and goes on.

    The person walks where the robot has walked, so through doorways and around furniture, and stands while
    the robot is near.

    Attributes:
        at: Where the person is.
    """

    def __init__(self, person: Person) -> None:
        """Stand where the scene has the person."""
        self.at = Standing(*person.position_m, person.yaw_rad)
        self._speed_m_s = person.speed_m_s
        self._nearest_m = math.inf
        self._led = False
        self._way: deque[tuple[float, float]] = deque()

    def tick(self, robot: tuple[float, float], passed_s: float) -> None:
        """Go on for a while.

        Args:
            robot: Where the robot's base is on the floor, in the world, m.
            passed_s: How long, s.
        """
        away_m = math.dist(robot, (self.at.x_m, self.at.y_m))
        self._nearest_m = min(self._nearest_m, away_m)
        self._led = self._led or (self._nearest_m <= MET_M and away_m > self._nearest_m + _GONE_ON_M)
        if not self._led:
            return
        if not self._way or math.dist(self._way[-1], robot) >= _CRUMB_M:
            self._way.append(robot)
            self._forget_the_way_round()
        left_m = self._speed_m_s * passed_s
        while self._way and left_m > 0.0 and math.dist(robot, (self.at.x_m, self.at.y_m)) > BEHIND_M:
            to_x, to_y = self._way[0]
            away_m = math.dist((self.at.x_m, self.at.y_m), (to_x, to_y))
            if away_m <= left_m:
                self._way.popleft()
                self.at = Standing(to_x, to_y, self.at.yaw_rad)
                left_m -= away_m
                continue
            share = left_m / away_m
            x = self.at.x_m + share * (to_x - self.at.x_m)
            y = self.at.y_m + share * (to_y - self.at.y_m)
            self.at = Standing(x, y, math.atan2(to_y - self.at.y_m, to_x - self.at.x_m))
            left_m = 0.0

    def _forget_the_way_round(self) -> None:
        """Go on from where the robot has passed by nearest: it may have come from elsewhere before."""
        away_m = [math.dist((self.at.x_m, self.at.y_m), crumb) for crumb in self._way]
        for _ in range(away_m.index(min(away_m))):
            self._way.popleft()
