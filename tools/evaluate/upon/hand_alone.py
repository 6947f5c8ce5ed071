"""Whether a hand that comes alone could take a thing where it is: every way across it, by what is solid.

This is what suites ask before they ask for a thing, so that a robot is not judged by what its own planner
finds. It looks for no good grasp: each two sides of the thing that face each other are tried, the hand turned
about the line between them in small steps and moved along its fingers, with the hand's own solids against
all others. It has to hold also where the hand comes a little beside that: no place is known better than so.
Neither an arm nor the choices of the generator of grasps have a part in it.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from kinematics.arrays import Array
from kinematics.collision.validity import hand_judge
from kinematics.geometry.shapes import Box, Cylinder, Shape
from kinematics.model.robot_description import GripperDescription, Hand
from kinematics.model.robot_model import RobotModel
from kinematics.planning.shape_grasps import facing_sides
from kinematics.scene.planning_scene import PlanningScene, SceneObject

CONE_RAD = math.radians(25.0)
"""Friction 0.6 holds to 31 degrees between a normal and the line across; poses are wrong by some."""
SPARE_M = 0.006
"""Free on each side of the thing between open fingers: where it is is known to so much at best."""
_WRONG = 0.005 * np.array([[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]])
"""What a hand may be beside its place, m, in its own frame; along the opening it has what is spare."""
_SAMPLES, _TURNS, _MOST_LINES = 700, 32, 1500
_NEAR_TIP, _DEPTHS = 0.5, 5
"""So far beyond the middle of the pads, in shares of half of them, what is held may be towards their ends."""
_OFF_M = 0.10
_STEPS = 6
"""Of a straight way in, m, looked at in so many places."""
_PATCH_M = 0.003
_PRESSING = 2
_AT_ONCE = 4000


class _Surface(NamedTuple):
    """Points of a thing, and outward normals there, in the world, shape (n, 3) each."""

    points: Array
    normals: Array


def hand_takes(model: RobotModel, hand: Hand, scene: PlanningScene, target: str) -> bool:
    """Whether a two-sided hand could take something where it is, if it had no arm.

    Args:
        model: The robot.
        hand: Which of its hands.
        scene: What is there, with the margins that a hand keeps; the floor included where it counts.
        target: Name of the thing.
    """
    return next(ways_to_take(model, hand, scene, target), None) is not None


def ways_to_take(
    model: RobotModel, hand: Hand, scene: PlanningScene, target: str, spare_m: float = SPARE_M
) -> Iterator[Array]:
    """Where the TCP of such a hand could take it, in no order; other arguments as of ``hand_takes``.

    Args:
        spare_m: Free on each side of the thing; with less than the usual nothing is asked of what is beside.
    """
    gripper, item = model.description.grippers[hand], scene.objects[target]
    judge = hand_judge(model, hand, scene, target, 0.0)
    own = PlanningScene().with_object(SceneObject("thing", item.shape, item.world_T_object))
    itself = hand_judge(model, hand, own, "", spare_m)
    surface = surface_of_thing(item)
    away = np.linspace(0.0, -_OFF_M, _STEPS).tolist()

    def held(poses: Array) -> list[Array]:
        free = poses[judge.fits_along(poses, [gripper.closing_advance_m, *away])]
        free = free[itself.fits_along(free, away)] if len(free) else free
        return [pose for pose in free if _holds(pose, surface, gripper, spare_m)]

    def sure(pose: Array) -> bool:
        return spare_m < SPARE_M or len(held(_beside(pose))) == len(_WRONG)

    for poses in _poses_across(surface, gripper, spare_m):
        yield from filter(sure, held(poses))


def _beside(pose: Array) -> Array:
    """Where a hand comes that is wrong along its fingers or across them, shape (4, 4, 4)."""
    wrong = np.repeat(pose[None], len(_WRONG), axis=0)
    wrong[:, :3, 3] += _WRONG @ pose[:3, :3].T
    return wrong


def surface_of_thing(item: SceneObject) -> _Surface:
    """Points all over a thing, in the world: of its parts, or of its outline where it is that."""
    parts = item.shape.parts
    if parts is not None and len(parts.surface):
        points, normals = parts.surface[:_SAMPLES], parts.normals[:_SAMPLES]
    else:
        points, normals = _of_outline(item.shape)
    rotation, place = item.world_T_object[:3, :3], item.world_T_object[:3, 3]
    return _Surface(points @ rotation.T + place, normals @ rotation.T)


def _of_outline(shape: Shape) -> tuple[Array, Array]:
    """The same of a box, a cylinder's side or a ball, in its own frame, evenly."""
    rng = np.random.default_rng(0)
    if isinstance(shape, Box):
        half = 0.5 * np.array(shape.size_m)
        points = rng.uniform(-half, half, (_SAMPLES, 3))
        face, sign = rng.integers(0, 3, _SAMPLES), rng.choice([-1.0, 1.0], _SAMPLES)
        rows = np.arange(_SAMPLES)
        points[rows, face] = sign * half[face]
        normals = np.zeros((_SAMPLES, 3))
        normals[rows, face] = sign
        return points, normals
    normals = rng.normal(size=(_SAMPLES, 3))
    if isinstance(shape, Cylinder):
        normals[:, 2] = 0.0
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    points = shape.radius_m * normals
    if isinstance(shape, Cylinder):
        points[:, 2] = rng.uniform(-0.5 * shape.height_m, 0.5 * shape.height_m, _SAMPLES)
    return points, normals


def _poses_across(surface: _Surface, gripper: GripperDescription, spare_m: float) -> Iterator[Array]:
    """Poses of the TCP, many at a time, shape (n, 4, 4): at each line across, turned and moved along x."""
    points, normals = surface
    apart, worst = facing_sides(points, normals, points, normals)
    length = np.linalg.norm(apart, axis=2) + 1e-12
    widest, least = gripper.max_opening_m - 2.0 * spare_m, gripper.least_felt_m
    facing = (worst >= math.cos(CONE_RAD)) & (length >= least) & (length <= widest)
    first, second = np.nonzero(facing)
    chosen = np.random.default_rng(0).permutation(len(first))[:_MOST_LINES]
    first, second = first[chosen], second[chosen]
    half_long = max(half[2] for half in gripper.pad_half_size_m)
    depths = _NEAR_TIP * half_long * np.linspace(-1.0, 1.0, _DEPTHS)
    each = _AT_ONCE // (_TURNS * _DEPTHS)
    for begin in range(0, len(first), each):
        rows = slice(begin, begin + each)
        y = apart[first[rows], second[rows]] / length[first[rows], second[rows]][:, None]
        middle = points[first[rows]] + 0.5 * apart[first[rows], second[rows]]
        yield _turned(middle, y, depths)


def _turned(middle: Array, y: Array, depths: Array) -> Array:
    """All turns of a hand about lines, at all depths, shape (lines × turns × depths, 4, 4)."""
    other = np.where(np.abs(y[:, 2:]) < 0.9, np.array([0.0, 0.0, 1.0]), np.array([1.0, 0.0, 0.0]))
    u = np.cross(y, other)
    u /= np.linalg.norm(u, axis=1)[:, None]
    v = np.cross(y, u)
    angle = 2.0 * math.pi * np.arange(_TURNS) / _TURNS
    x = np.cos(angle)[None, :, None] * u[:, None] + np.sin(angle)[None, :, None] * v[:, None]
    poses = np.zeros((len(middle), _TURNS, len(depths), 4, 4))
    poses[..., :3, 0] = x[:, :, None]
    poses[..., :3, 1] = y[:, None, None]
    poses[..., :3, 2] = np.cross(x, np.broadcast_to(y[:, None], x.shape))[:, :, None]
    poses[..., :3, 3] = middle[:, None, None] - depths[:, None] * x[:, :, None]
    poses[..., 3, 3] = 1.0
    return poses.reshape(-1, 4, 4)


def _holds(pose: Array, surface: _Surface, gripper: GripperDescription, spare_m: float) -> bool:
    """Whether pads that close there press on two sides that face each other, not too near nor too far."""
    half_long = max(half[2] for half in gripper.pad_half_size_m)
    x, y, z = ((surface.points - pose[:3, 3]) @ pose[:3, :3]).T
    wide = np.abs(y) <= 0.5 * gripper.max_opening_m
    between = wide & (np.abs(x) <= half_long) & (np.abs(z) <= gripper.fingers_half_width_m)
    if not between.any():
        return False
    low, high = float(y[between].min()), float(y[between].max())
    if not gripper.least_felt_m <= high - low <= gripper.max_opening_m - 2.0 * spare_m:
        return False
    along = surface.normals @ pose[:3, 1]
    for end, sign in ((low, -1.0), (high, 1.0)):
        pressed = between & (np.abs(y - end) <= _PATCH_M)
        if np.sum(sign * along[pressed] >= math.cos(CONE_RAD)) < _PRESSING:
            return False
    return True
