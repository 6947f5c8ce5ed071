"""Is this configuration, this row of points, this whole edge free? Answered by compiled code.

The meaning of margins, allowed pairs and attached bodies is that of
``kinematics.collision.collision_world.CollisionWorld``; the meaning of a free point that of
``kinematics.planning.path_planner.PathPlanner``. An edge is proven free as a whole.
"""

from __future__ import annotations

import copy

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array, Indices, as_float64
from kinematics.errors import InvalidArrayError
from kinematics.kernel import door, judge
from kinematics.kernel.buffers import Buffers
from kinematics.kernel.memory import Packed
from kinematics.kernel.packing import JUDGED_ROW, Sizes, pack
from kinematics.kernel.refusal import REASONS, NotFree, Refusal
from kinematics.kernel.robot_arrays import RobotArrays
from kinematics.kernel.scene_solids import judged_in, scene_solids
from kinematics.kernel.tuning import Tuning
from kinematics.model.robot_model import RobotModel
from kinematics.model.standing_robot import StandingRobot
from kinematics.scene.planning_scene import PlanningScene
from kinematics.standing.flat_coordinates import Coordinates, Limits
from kinematics.standing.model_coordinates import (
    mounted_coordinates,
    mounted_limits,
    standing_coordinates,
    standing_limits,
)

# Most intervals that an edge is cut into before it counts as not proven.
EFFORT = 4000

TUNING = Tuning(
    first_reach_rad=0.2,
    hopeless=0.5,
    enough=1.5,
    point_step_rad=0.15,
    shortcut_m=0.001,
    shortcut_effort=400.0,
    shortcut_gain=0.02,
)
"""What was fastest for picks and for the benchmark's scenes."""

# Most corners of a polyline that is searched, and those that shortening may add.
_MOST_ROWS = 1000
_ROOM_ROWS = 64


class _Shared:
    """A problem's memory, and which pairs of it are judged at present."""

    def __init__(self, packed: Packed, judged: Indices, buffers: Buffers) -> None:
        # the buffers are kept: compiled code is given where they are
        self._packed, self.judged, self._buffers = packed, judged, buffers
        self.addresses = packed.floats.ctypes.data, packed.ints.ctypes.data, packed.table
        begin = int(packed.table[JUDGED_ROW, 0])
        self._place = packed.ints[begin : begin + judged.size].reshape(judged.shape)

    def __del__(self) -> None:
        """The next problem is laid out in the same memory."""
        self._buffers.give_back(self._packed.floats, self._packed.ints)

    def judge(self, judged: Indices) -> None:
        """Judge these pairs from now on."""
        self._place[...] = judged
        self.judged = judged


class CollisionKernel:
    """A robot in a planning scene.

    One is used by one thread: it remembers what separated each pair last. That makes it faster and
    may move a verdict only within the last micrometre of a margin; the same questions in the same
    order get the same answers to the bit.

    Args:
        robot: The robot's arrays, made once.
        scene: What is around, what is held, and which pairs may touch.
        space: How free coordinates make configurations; every joint on its own when left out.
        limits: What a posture must keep; nothing when left out.
        extra_margin_m: Added to every margin of the scene.
        self_margin_m: Distance kept between the robot's own links.

    Raises:
        UnknownNameError: A body is attached to a frame that the robot does not have.
    """

    def __init__(
        self,
        robot: RobotArrays,
        scene: PlanningScene,
        space: Coordinates | None = None,
        limits: Limits | None = None,
        extra_margin_m: float = 0.0,
        self_margin_m: float = 0.0,
    ) -> None:
        if space is None:
            space, free = robot.every_joint
            limits = free if limits is None else limits
        elif limits is None:
            limits = robot.every_joint[1]
        alone = robot.alone(space, self_margin_m)
        found = scene_solids(robot, alone, scene, extra_margin_m)
        chains, self._own = found.moves.chains, found.moves.own
        self._robot, self._scene = robot, scene
        self._moving, objects = found.moves.carriers.moving, len(found.object_margin)
        self._names, self._nq = found.names, len(limits.lower)
        self.size = 6 * space.floating + len(space.columns)
        self.pair_count = len(self._own.first) + objects * self._moving
        sizes = Sizes(
            bodies=len(robot.tree.parent),
            depth=chains.joint.shape[1],
            free=self.size,
            nq=self._nq,
            moving=self._moving,
            objects=objects,
            own_pairs=len(self._own.first),
        )
        blocks = [robot.fixed(space, limits, TUNING), found.moves.laid_out, found.laid_out]
        packed = pack(robot.hulls, found.vertices, blocks, sizes, robot.buffers)
        self._shared = _Shared(packed, found.judged, robot.buffers)
        self._judged = found.judged
        self._nothing = np.empty(0)

    def allowing(self, scene: PlanningScene) -> CollisionKernel | None:
        """The same with other pairs that may touch, at no cost: it shares the memory of this one.

        Args:
            scene: One that was made of this one's scene by allowing pairs.

        Returns:
            None when the scene differs in more than that, or in what a held body may touch of the robot:
            those pairs are no part of what can be changed.
        """
        mine = self._scene
        if scene.objects is not mine.objects or scene.attached is not mine.attached:
            return None
        if mine.attached and any(pair.isdisjoint(mine.objects) for pair in scene.allowed ^ mine.allowed):
            return None
        other = copy.copy(self)
        other._scene, other._judged = scene, judged_in(self._robot, scene)
        return other

    def path_search(self) -> CollisionKernel:
        """Itself: paths are searched in compiled code, too."""
        return self

    @classmethod
    def standing(
        cls,
        arrays: RobotArrays,
        robot: StandingRobot,
        scene: PlanningScene,
        extra_margin_m: float = 0.0,
        self_margin_m: float = 0.0,
    ) -> CollisionKernel:
        """A robot on planted feet, over the coordinates of ``FreeCoordinates``.

        Raises:
            ModelError: The robot's legs have no closed form.
            UnknownNameError: A body is attached to a frame that the robot does not have.
        """
        space, limits = standing_coordinates(robot), standing_limits(robot)
        return cls(arrays, scene, space, limits, extra_margin_m, self_margin_m)

    @classmethod
    def mounted(
        cls,
        robot: RobotArrays,
        model: RobotModel,
        scene: PlanningScene,
        extra_margin_m: float = 0.0,
        self_margin_m: float = 0.0,
    ) -> CollisionKernel:
        """A welded robot, over the coordinates of ``FreeCoordinates``.

        Raises:
            UnknownNameError: A body is attached to a frame that the robot does not have.
        """
        space, limits = mounted_coordinates(model, robot.tree), mounted_limits(model)
        return cls(robot, scene, space, limits, extra_margin_m, self_margin_m)

    def collides(self, q: Array) -> bool:
        """Tell whether any pair that may not touch is nearer than its margin, at ``q``, shape (nq,)."""
        return self._ask(door.AT_CONFIGURATION, self._posture(q))[0] != judge.FREE

    def contacts(self, q: Array) -> NDArray[np.bool_]:
        """``collides`` of many configurations, shape (n, nq), at once, shape (n,)."""
        postures = as_float64(q, (None, self._nq), "q")
        found = np.empty(len(postures))
        self._ask(door.CONTACTS, postures, 0.0, found)
        return np.asarray(found >= 0.0)

    def colliding_pair(self, q: Array) -> tuple[str, str] | None:
        """Names of the first pair that collides, or None."""
        refusal = self._refusal(self._ask(door.AT_CONFIGURATION, self._posture(q)))
        return None if refusal is None else refusal.pair

    def not_free(self, x: Array) -> NotFree | None:
        """What was found at a point, shape (size,), that is not free; None at one that is."""
        refusal = self._refusal(self._ask(door.AT_POINTS, self._point(x)))
        return None if refusal is None else NotFree(refusal.reason, refusal.pair)

    def why_not(self, x: Array) -> str | None:
        """Why a point, shape (size,), is not free, in words for people; None when it is."""
        found = self.not_free(x)
        return None if found is None else str(found)

    def is_free(self, x: Array) -> bool:
        """Tell whether one point, shape (size,), keeps feet, limits, balance and distances."""
        return self._ask(door.AT_POINTS, self._point(x))[0] == judge.FREE

    def points_are_free(self, x: Array) -> bool:
        """Tell whether every one of many points, shape (n, size), is free."""
        return self._ask(door.AT_POINTS, self._points(x))[0] == judge.FREE

    def edge_is_free(self, a: Array, b: Array, effort: int = EFFORT) -> bool:
        """Tell whether the whole line between two points, shape (size,) each, is proven to be free."""
        return self.polyline_is_free(np.stack((a, b)), effort)

    def polyline_is_free(self, x: Array, effort: int = EFFORT) -> bool:
        """Tell whether the lines between neighbouring points, shape (n, size), are proven to be free."""
        return self._ask(door.ALONG_POINTS, self._points(x), effort)[0] == judge.FREE

    def polyline_refusal(self, x: Array, effort: int = EFFORT) -> Refusal | None:
        """Why lines between neighbouring points, shape (n, size), are not free, or None."""
        return self._refusal(self._ask(door.ALONG_POINTS, self._points(x), effort))

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
        """Search a polyline between two points, all of whose lines are proven to be free.

        Args:
            start, goal: Shape (size,).
            lower, upper: Box of the samples, shape (size,).
            weights: Of the coordinates in distances, shape (size,).
            extend: The longest step of a tree, weighted.
            iterations: Most samples.
            seed: Of the samples, 0 to 2**53 - 1; the same one gives the same answer.

        Returns:
            Shape (n, size), or None when none was found.
        """
        points = self._points(np.stack([start, goal, lower, upper, weights]))
        found = np.empty(_MOST_ROWS * self.size)
        found[0] = seed
        found[1] = extend
        _, rows, _ = self._ask(door.CONNECT, points, iterations, found)
        return found[: int(rows) * self.size].reshape(-1, self.size).copy() if rows > 0.0 else None

    def shorten(self, polyline: Array, weights: Array, attempts: int) -> Array:
        """Cut corners of a free polyline off, by lines that are proven to be free.

        Args:
            polyline: Shape (n, size).
            weights: Of the coordinates in its length, shape (size,).
            attempts: Most lines that are tried; fewer give an answer too, a longer one.
        """
        points = self._points(np.vstack([weights, polyline]))
        if len(points) < 2:
            raise InvalidArrayError("polyline", "has no points")
        found = np.empty((2 * (len(points) - 1) + _ROOM_ROWS) * self.size)
        rows = int(self._ask(door.SHORTEN, points, attempts, found)[1])
        return found[: rows * self.size].reshape(-1, self.size).copy()

    def distances_m(self, q: Array, cap_m: float = 1.0) -> Array:
        """Lower bounds of the distances of all pairs at a configuration, shape (pair_count,).

        Within a micrometre of the distance where that is below ``cap_m``; 0 or less where a pair
        touches or overlaps; infinite for pairs that may touch. ``pair_names`` tells which they are.
        """
        found = np.empty(self.pair_count)
        self._ask(door.DISTANCES, self._posture(q), cap_m, found)
        return found

    def pair_names(self, pair: int) -> tuple[str, str]:
        """Names of the two solids of a pair."""
        own = self._own
        if pair < len(own.first):
            return self._names[own.first[pair]], self._names[own.second[pair]]
        thing, solid = divmod(pair - len(own.first), self._moving)
        return self._names[solid], self._names[self._moving + thing]

    def configuration(self, x: Array) -> Array | None:
        """Configuration of one point, shape (nq,), or None when a foot cannot be kept."""
        q = np.empty(self._nq)
        return q if self._ask(door.TO_CONFIGURATION, self._point(x), 0.0, q)[0] == judge.FREE else None

    def _posture(self, q: Array) -> Array:
        """The row of one configuration: compiled code believes what it is told of sizes."""
        return as_float64(q, (self._nq,), "q")[None]

    def _point(self, x: Array) -> Array:
        """The row of one point of free coordinates."""
        return as_float64(x, (self.size,), "x")[None]

    def _points(self, x: Array) -> Array:
        """Rows of points of free coordinates."""
        return as_float64(x, (None, self.size), "x")

    def _ask(
        self, question: int, points: Array, number: float = 0.0, found: Array | None = None
    ) -> tuple[int, float, int]:
        # one type of argument only, so that nothing is ever compiled anew: see ``as_float64``
        found = self._nothing if found is None else found
        shared = self._shared
        if shared.judged is not self._judged:
            shared.judge(self._judged)
        return door.ask(*shared.addresses, question, points, float(number), found)

    def _refusal(self, answer: tuple[int, float, int]) -> Refusal | None:
        verdict, at, pair = answer
        if verdict == judge.FREE:
            return None
        return Refusal(REASONS[verdict], at, None if pair < 0 else self.pair_names(pair))
