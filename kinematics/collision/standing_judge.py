"""Judges postures of a motion that is made as it goes, where no trajectory checker comes after.

It judges what planned motions leave to the checker too: the floor, and the legs against each other.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from kinematics.arrays import Array
from kinematics.collision.collision_world import with_floor
from kinematics.collision.leg_room import leg_room
from kinematics.collision.validity import validity
from kinematics.kernel.refusal import NotFree
from kinematics.model.standing_robot import StandingRobot
from kinematics.scene.planning_scene import FLOOR, PlanningScene
from kinematics.standing.reserves import BRAKING_RESERVE_M


@dataclass(frozen=True, slots=True)
class Kept:
    """Distances that postures keep, m, so that a motion that is stopped comes to rest before it touches.

    Attributes:
        own_m: Between the robot's own links, the legs' left out.
        floor_m: Between the floor and all but the soles.
        legs_m: Between the links of the legs.
    """

    own_m: float = BRAKING_RESERVE_M
    floor_m: float = BRAKING_RESERVE_M
    legs_m: float = BRAKING_RESERVE_M


class StandingJudge:
    """Tells whether postures of a robot on planted feet, or on its mount, are free in one scene.

    Attributes:
        kept: What it keeps from the floor and between the robot's links.
    """

    def __init__(self, robot: StandingRobot, scene: PlanningScene, kept: Kept) -> None:
        """Prepare.

        Args:
            robot: Where it stands.
            scene: What is around, what is held, and which pairs may touch.
            kept: What is kept from the floor and between the robot's links; the scene says the rest.
        """
        self.kept = kept
        scene = with_floor(robot.model, scene)
        ground = scene.objects[FLOOR]
        scene = scene.with_object(replace(ground, margin_m=max(ground.margin_m, kept.floor_m)))
        self._validity = validity(robot, scene, self_margin_m=kept.own_m)
        self._legs = leg_room(robot.model, kept.legs_m)

    @classmethod
    def beginning_at(cls, robot: StandingRobot, scene: PlanningScene, x: Array, q: Array) -> StandingJudge:
        """The judge of a motion that begins at a posture: it keeps no reserve where that has less.

        Args:
            robot, scene: As of the class.
            x, q: The posture, as of ``is_free``.
        """
        whole = cls(robot, scene, Kept())
        if whole.is_free(x, q):
            return whole
        # each reserve alone: one that is not there says nothing about the others
        usual = Kept()
        alone = Kept(usual.own_m, 0.0, 0.0), Kept(0.0, usual.floor_m, 0.0), Kept(0.0, 0.0, usual.legs_m)
        there = [cls(robot, scene, kept).is_free(x, q) for kept in alone]
        own_m, floor_m, legs_m = (BRAKING_RESERVE_M if free else 0.0 for free in there)
        return cls(robot, scene, Kept(own_m, floor_m, legs_m))

    def is_free(self, x: Array, q: Array) -> bool:
        """Tell whether a posture is free.

        Args:
            x: Its free coordinates, shape (size,).
            q: The same with its legs, shape (nq,).
        """
        return self._validity.points_are_free(x[None]) and (self._legs is None or not self._legs.touches(q))

    def points_are_free(self, x: Array) -> bool:
        """Tell whether each of many postures, shape (n, size), is free whose legs stay where they are."""
        return self._validity.points_are_free(x)

    def why_not(self, x: Array) -> str | None:
        """Why one of these, shape (size,), is not free, in words for people; None when it is."""
        return self._validity.why_not(x)

    def configuration(self, x: Array) -> Array | None:
        """Configuration of a point, shape (nq,), or None when a foot cannot be kept."""
        return self._validity.configuration(x)

    def not_free(self, x: Array, q: Array) -> NotFree | None:
        """What was found at a posture that is not free, or None; arguments as of ``is_free``."""
        found = self._validity.not_free(x)
        if found is not None or self._legs is None:
            return found
        pair = self._legs.touching(q)
        return None if pair is None else NotFree("contact", pair)
