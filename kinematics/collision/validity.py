"""Which points and lines of a robot's free coordinates are free: the planner's judge.

The compiled kernel judges robots whose legs have a closed form; Coal, point by point, all others, and
all of them where the kernel was not compiled.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from typing import TYPE_CHECKING, Protocol

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.collision.collision_world import CollisionWorld, HandCollision, with_floor
from kinematics.compiled import readiness
from kinematics.errors import ModelError
from kinematics.kernel.refusal import NotFree
from kinematics.model.robot_build import RobotBuild, robot_build
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel
from kinematics.model.standing_robot import StandingRobot
from kinematics.scene.planning_scene import PlanningScene
from kinematics.standing.free_coordinates import free_coordinates
from kinematics.standing.reserves import COM_RESERVE_M, LIMIT_NOISE_RAD

if TYPE_CHECKING:
    from kinematics.kernel.robot_arrays import RobotArrays


# Weighted distance (about radians) of two judged points of a line: some 2 cm at the fingertips.
RESOLUTION = 0.04


class Validity(Protocol):
    """Judges reach of the legs, limits, balance and collision."""

    def points_are_free(self, x: Array) -> bool:
        """Tell whether every one of many points, shape (n, size), is free."""
        ...

    def polyline_is_free(self, x: Array) -> bool:
        """Tell whether the lines between neighbouring points, shape (n, size), are free."""
        ...

    def colliding_pair(self, q: Array) -> tuple[str, str] | None:
        """Names of a pair that collides at a configuration, shape (nq,), or None."""
        ...

    def configuration(self, x: Array) -> Array | None:
        """Configuration of one point, shape (nq,), or None when a foot cannot be kept."""
        ...

    def not_free(self, x: Array) -> NotFree | None:
        """What was found at a point, shape (size,), that is not free; None at one that is."""
        ...

    def why_not(self, x: Array) -> str | None:
        """Why a point, shape (size,), is not free, in words for people; None when it is."""
        ...

    def allowing(self, scene: PlanningScene) -> Validity | None:
        """A judge of the same in a scene in which other pairs may touch; None when it is better made anew."""
        ...

    def path_search(self) -> PathSearch | None:
        """The same judge when it searches paths itself, else None."""
        ...


class PathSearch(Protocol):
    """A judge that searches paths itself; see ``CollisionKernel``."""

    def connect(
        self,
        start: Array,
        goal: Array,
        lower: Array,
        upper: Array,
        weights: Array,
        extend: float,
        iterations: int,
        seed: int,
    ) -> Array | None:
        """Search a proven polyline, shape (n, size), or None."""
        ...

    def shorten(self, polyline: Array, weights: Array, attempts: int) -> Array:
        """Cut corners of a proven polyline off, by proven lines."""
        ...


class HandJudge(Protocol):
    """Tells where an open hand alone has room; see ``HandCollision``."""

    def collisions(self, world_T_tcp: Array) -> NDArray[np.bool_]:
        """Tell whether the hand is too near to anything, by pose, shape (n, 4, 4) to (n,)."""
        ...

    def fits_along(self, world_T_tcp: Array, along_m: Sequence[float]) -> NDArray[np.bool_]:
        """Tell whether it has room at poses, shape (n, 4, 4), moved along their x axis by each distance."""
        ...

    def clearance_m(self, world_T_tcp: Array, enough_m: float) -> float:
        """Room beyond the margins at one pose; no more than ``enough_m`` is measured."""
        ...


def hand_judge(
    model: RobotModel, hand: Hand, scene: PlanningScene, target: str, extra_margin_m: float
) -> HandJudge:
    """The judge of an open hand, by the kernel where it is compiled; arguments as of ``HandCollision``."""
    if not _kernel_is_there():
        return HandCollision(model, hand, scene, target, extra_margin_m)
    # imported here: it brings the compiler
    from kinematics.kernel.hand_kernel import HandKernel

    return HandKernel(robot_build(model).derived(_hand_arrays, hand), scene, target, extra_margin_m)


def validity(
    robot: StandingRobot,
    scene: PlanningScene,
    extra_margin_m: float = 0.0,
    self_margin_m: float = 0.0,
    like: Validity | None = None,
) -> Validity:
    """The judge of a robot on planted feet, or on its mount, in a planning scene.

    Args:
        robot: Where it stands.
        scene: What is around, what is held, and which pairs may touch.
        extra_margin_m: Added to every margin of the scene.
        self_margin_m: Distance kept between the robot's own links.
        like: A judge with all the same but the scene; where only allowed pairs differ, its memory is used.
    """
    if like is not None and (adapted := like.allowing(scene)) is not None:
        return adapted
    model = robot.model
    if not _kernel_is_there():
        return SampledValidity(robot, CollisionWorld(model, scene, extra_margin_m, self_margin_m))
    # imported here: it brings the compiler
    from kinematics.kernel.collision_kernel import CollisionKernel

    arrays = robot_build(model).derived(_arrays)
    if model.description.welded:
        scene = with_floor(model, scene)
        return CollisionKernel.mounted(arrays, model, scene, extra_margin_m, self_margin_m)
    try:
        return CollisionKernel.standing(arrays, robot, scene, extra_margin_m, self_margin_m)
    except ModelError:  # legs without a closed form: nothing is proven along lines, and postures are judged
        world = CollisionKernel(arrays, scene, None, None, extra_margin_m, self_margin_m)
        return SampledValidity(robot, world)


def _kernel_is_there() -> bool:
    """To compile it takes minutes, Coal judges at once."""
    return readiness.usable()


def _arrays(build: RobotBuild) -> RobotArrays:
    from kinematics.kernel.robot_arrays import humanoid_arrays

    return humanoid_arrays(build.model)


def _hand_arrays(build: RobotBuild, hand: Hand) -> RobotArrays:
    from kinematics.kernel.hand_kernel import hand_arrays

    return hand_arrays(build.model, hand)


class PostureJudge(Protocol):
    """Tells what collides at a configuration, shape (nq,)."""

    def collides(self, q: Array) -> bool:
        """Whether any pair that may not touch is nearer than its margin."""
        ...

    def colliding_pair(self, q: Array) -> tuple[str, str] | None:
        """Names of the first pair that collides, or None."""
        ...


class SampledValidity:
    """Judges point by point: by the kernel where it is compiled, else with Coal."""

    def __init__(self, robot: StandingRobot, world: PostureJudge) -> None:
        model = robot.model
        self._model, self._world = model, world
        self._space, self._polygon = free_coordinates(robot), robot.polygon
        margin = model.description.planning_margin_rad
        self._lower = model.lower_rad + margin - LIMIT_NOISE_RAD
        self._upper = model.upper_rad - margin + LIMIT_NOISE_RAD

    def points_are_free(self, x: Array) -> bool:
        """Tell whether every one of many points, shape (n, size), is free."""
        q, reached = self._space.to_q(x)
        joints = q[:, 7:]
        if not reached.all() or np.any(joints < self._lower) or np.any(joints > self._upper):
            return False
        margin = self._model.description.com_margin_m + COM_RESERVE_M
        # both ends first, then the middle: what collides is found early
        for k in _bisecting(len(q)):
            if self._world.collides(q[k]):
                return False
            if self._polygon.com_margin_m(self._model.com(q[k])) < margin:
                return False
        return True

    def polyline_is_free(self, x: Array) -> bool:
        """Tell whether lines between neighbouring points are free at points of the resolution."""
        pieces = []
        for a, b in itertools.pairwise(x):
            count = max(1, int(np.ceil(self._space.distance(a, b) / RESOLUTION)))
            pieces.append(a + (b - a) * np.arange(count)[:, None] / count)
        return self.points_are_free(np.concatenate([*pieces, x[-1:]]))

    def colliding_pair(self, q: Array) -> tuple[str, str] | None:
        """Names of the first pair that collides, or None."""
        return self._world.colliding_pair(q)

    def configuration(self, x: Array) -> Array | None:
        """Configuration of one point, shape (nq,), or None when a foot cannot be kept."""
        (q,), (reached,) = self._space.to_q(x[None])
        return q if reached else None

    def not_free(self, x: Array) -> NotFree | None:
        """What is found first at a point that is not free, in the kernel's order; None at one that is."""
        (q,), (reached,) = self._space.to_q(x[None])
        if not reached:
            return NotFree("reach")
        if np.any(q[7:] < self._lower) or np.any(q[7:] > self._upper):
            return NotFree("limits")
        least_m = self._model.description.com_margin_m + COM_RESERVE_M
        if self._polygon.com_margin_m(self._model.com(q)) < least_m:
            return NotFree("balance")
        pair = self.colliding_pair(q)
        return None if pair is None else NotFree("contact", pair)

    def why_not(self, x: Array) -> str | None:
        """Why a point is not free, in words for people; None when it is."""
        found = self.not_free(x)
        return None if found is None else str(found)

    def allowing(self, scene: PlanningScene) -> None:
        """Nothing is shared."""

    def path_search(self) -> None:
        """Who plans has to search itself."""


def _bisecting(count: int) -> list[int]:
    """Indices 0 to count - 1: the ends first, then the middles of ever smaller gaps."""
    order, gaps = [0, count - 1][: min(count, 2)], [(0, count - 1)]
    while gaps:
        wider = []
        for low, high in gaps:
            if high - low > 1:
                middle = (low + high) // 2
                order.append(middle)
                wider += [(low, middle), (middle, high)]
        gaps = wider
    return order
