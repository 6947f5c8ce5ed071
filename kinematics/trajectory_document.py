"""A trajectory as text: the JSON document of docs/trajectory.schema.json.

Read strictly: whatever is missing, unknown, doubled, not finite or out of all proportion is an error
that names its place. Written exactly: times, configurations and velocities come back bit by bit.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from kinematics import poses
from kinematics.json_reader import Node, parse_document
from kinematics.poses import Transform
from kinematics.scene import Pair, SceneObject
from kinematics.shapes import Ball, Box, Cylinder, Shape
from kinematics.trajectory import Array, Stance, Trajectory

SCHEMA = 1
MAX_SAMPLES = 100_000
MAX_JOINTS = 1_000
MAX_ENTRIES = 10_000
"""Held objects, soles and allowed pairs."""
MAX_DURATION_S = 600.0
"""Ten minutes: the work of a check grows with the duration."""
MIN_SPACING_S = 1e-6
"""Nearer samples are no motion of any machine, and their differences drown in rounding."""
MAX_POSITION = 1e3
MAX_VELOCITY = 1e4
MAX_SIZE_M = 1e3
"""Bounds of plausibility, in m, rad and per second: beyond them sums of squares lose all meaning."""
UNIT_TOLERANCE = 1e-3
"""A quaternion of a pose may miss length 1 by this much; it is normalised."""
LEAST_QUATERNION = 0.1
"""A base quaternion shorter than this has no direction; one that is not quite 1 is the checker's to find."""

_BASE_Q = tuple(f"base {axis}" for axis in "xyz") + tuple(f"base quaternion {axis}" for axis in "xyzw")
_BASE_V = tuple(f"base {kind} {axis}" for kind in ("velocity", "angular velocity") for axis in "xyz")


@dataclass(frozen=True, slots=True)
class HeldObject:
    """An object that a frame of the robot carries during the whole motion.

    Attributes:
        name: Its name; a world object of the same name is the same thing, and leaves the world.
        frame: Frame of the robot that carries it.
        frame_T_object: Pose in that frame, shape (4, 4).
        shape: Its solid, centred on its own frame.
        touch_links: Links that may touch it.
    """

    name: str
    frame: str
    frame_T_object: Transform
    shape: Shape
    touch_links: frozenset[str] = frozenset()


@dataclass(frozen=True, slots=True)
class StoredTrajectory:
    """What a document holds; nothing in it has been compared with a robot yet.

    Attributes:
        robot: Name of the robot that the motion is made for.
        trajectory: The motion, in the world frame of its scene.
        held: What the robot carries meanwhile.
        allowed: Pairs of names (links, objects) that may touch.
        objects: What is around, in the trajectory's frame; None when the document does not say.
    """

    robot: str
    trajectory: Trajectory
    held: tuple[HeldObject, ...] = ()
    allowed: frozenset[Pair] = frozenset()
    objects: tuple[SceneObject, ...] | None = None


def write_trajectory(stored: StoredTrajectory) -> str:
    """The document, one line a sample."""
    motion = stored.trajectory
    head: dict[str, object] = {
        "schema": SCHEMA,
        "robot": stored.robot,
        "joints": list(motion.joints),
        "stance": {frame: _pose_json(world_T_sole) for frame, world_T_sole in motion.stance.soles},
    }
    if stored.held:
        head["held"] = [
            {
                "name": item.name,
                "frame": item.frame,
                "shape": _shape_json(item.shape),
                **_pose_json(item.frame_T_object),
                "touch_links": sorted(item.touch_links),
            }
            for item in stored.held
        ]
    if stored.allowed:
        head["allowed"] = sorted(sorted(pair) for pair in stored.allowed)
    if stored.objects is not None:
        head["objects"] = [
            {
                "name": item.name,
                "shape": _shape_json(item.shape),
                **_pose_json(item.world_T_object),
                "margin_m": item.margin_m,
            }
            for item in stored.objects
        ]
    samples = ",\n".join(
        json.dumps({"t_s": t_s, "q": q, "v": v})
        for t_s, q, v in zip(motion.t_s.tolist(), motion.q.tolist(), motion.v.tolist(), strict=True)
    )
    lines = [f"{json.dumps(key)}: {json.dumps(value)}" for key, value in head.items()]
    return "{" + ",\n".join([*lines, f'"samples": [\n{samples}\n]']) + "}\n"


def read_trajectory(text: str) -> StoredTrajectory:
    """Read a document.

    Args:
        text: JSON, as ``docs/trajectory.schema.json`` describes it.

    Raises:
        TrajectoryDocumentError: With the place, such as ``samples[12].q[9] (arm_left_3_joint)``, and
            the reason.
    """
    root = parse_document(text)
    root.only(("schema", "robot", "joints", "stance", "samples"), ("held", "allowed", "objects"))
    schema = root.key("schema")
    if type(schema.value) is not int or schema.value != SCHEMA:  # JSON's true and 1.0 equal 1 too
        raise schema.error(f"must be {SCHEMA}, not {schema.shown()}")
    robot = root.key("robot").text()
    joints = tuple(item.text() for item in root.key("joints").items(0, MAX_JOINTS))
    _require_unique(root, "joints", joints)
    soles = tuple((frame, _pose(node)) for frame, node in root.key("stance").entries(MAX_ENTRIES))
    motion = _motion(root.key("samples"), joints, Stance(soles))
    held = tuple(_held(node) for node in _optional(root, "held"))
    _require_unique(root, "held", [item.name for item in held])
    pairs = frozenset(_pair(node) for node in _optional(root, "allowed"))
    if not root.has("objects"):
        return StoredTrajectory(robot, motion, held, pairs)
    objects = tuple(_object(node) for node in _optional(root, "objects"))
    _require_unique(root, "objects", [item.name for item in objects])
    return StoredTrajectory(robot, motion, held, pairs, objects)


def _optional(root: Node, key: str) -> list[Node]:
    return root.key(key).items(0, MAX_ENTRIES) if root.has(key) else []


def _require_unique(root: Node, key: str, names: Sequence[str]) -> None:
    seen: set[str] = set()
    for name in names:
        if name in seen:
            raise root.key(key).error(f"{name!r} is there twice")
        seen.add(name)


def _motion(samples: Node, joints: tuple[str, ...], stance: Stance) -> Trajectory:
    nodes = samples.items(2, MAX_SAMPLES)
    q_names, v_names = [*_BASE_Q, *joints], [*_BASE_V, *joints]
    times = np.empty(len(nodes))
    q, v = np.empty((len(nodes), len(q_names))), np.empty((len(nodes), len(v_names)))
    for i, node in enumerate(nodes):
        node.only(("t_s", "q", "v"))
        t_s = times[i] = node.key("t_s").number(MAX_DURATION_S)
        if i == 0 and t_s != 0.0:
            raise node.key("t_s").error(f"the first sample is at 0, not {t_s!r}")
        if i > 0 and not t_s - times[i - 1] >= MIN_SPACING_S:
            before = float(times[i - 1])
            raise node.key("t_s").error(
                f"must be at least {MIN_SPACING_S:g} s after {before!r}, the one before, not {t_s!r}"
            )
        q[i] = node.key("q").numbers(q_names, MAX_POSITION)
        if not float(np.linalg.norm(q[i, 3:7])) >= LEAST_QUATERNION:
            raise node.key("q").error("the base quaternion (3 to 6) vanishes")
        v[i] = node.key("v").numbers(v_names, MAX_VELOCITY)
    return Trajectory(joints, stance, times, q, v)


def _held(node: Node) -> HeldObject:
    node.only(("name", "frame", "shape", "position_m", "quaternion_xyzw"), ("touch_links",))
    return HeldObject(
        name=node.key("name").text(),
        frame=node.key("frame").text(),
        frame_T_object=_placed(node),
        shape=_shape(node.key("shape")),
        touch_links=frozenset(link.text() for link in _optional(node, "touch_links")),
    )


def _object(node: Node) -> SceneObject:
    node.only(("name", "shape", "position_m", "quaternion_xyzw"), ("margin_m",))
    margin_m = node.key("margin_m").number(MAX_SIZE_M) if node.has("margin_m") else 0.0
    if margin_m < 0.0:
        raise node.key("margin_m").error(f"must be 0 or more, not {margin_m!r}")
    return SceneObject(node.key("name").text(), _shape(node.key("shape")), _placed(node), margin_m)


def _pair(node: Node) -> Pair:
    first, second = (item.text() for item in node.items(2, 2))
    if first == second:
        raise node.error(f"{first!r} cannot touch itself")
    return frozenset((first, second))


def _pose(node: Node) -> Transform:
    node.only(("position_m", "quaternion_xyzw"))
    return _placed(node)


def _placed(node: Node) -> Transform:
    position: Array = node.key("position_m").numbers(("x", "y", "z"), MAX_POSITION)
    quaternion: Array = node.key("quaternion_xyzw").numbers(("x", "y", "z", "w"), 2.0)
    length = float(np.linalg.norm(quaternion))
    if abs(length - 1.0) > UNIT_TOLERANCE:
        raise node.key("quaternion_xyzw").error(f"must have length 1, not {length:.6g}")
    return poses.transform(poses.rotation_from_quaternion(quaternion), position)


def _pose_json(pose: Transform) -> dict[str, object]:
    quaternion = poses.quaternion_from_rotation(pose[:3, :3])
    return {"position_m": pose[:3, 3].tolist(), "quaternion_xyzw": quaternion.tolist()}


def _shape(node: Node) -> Shape:
    kind = node.key("kind").choice(("box", "cylinder", "ball"))
    if kind == "box":
        node.only(("kind", "size_m"))
        x, y, z = node.key("size_m").numbers(("x", "y", "z"), MAX_SIZE_M, positive=True)
        return Box((float(x), float(y), float(z)))
    if kind == "cylinder":
        node.only(("kind", "radius_m", "height_m"))
        radius_m = node.key("radius_m").number(MAX_SIZE_M, positive=True)
        return Cylinder(radius_m, node.key("height_m").number(MAX_SIZE_M, positive=True))
    node.only(("kind", "radius_m"))
    return Ball(node.key("radius_m").number(MAX_SIZE_M, positive=True))


def _shape_json(shape: Shape) -> dict[str, object]:
    match shape:
        case Box(size_m=size):
            return {"kind": "box", "size_m": list(size)}
        case Cylinder(radius_m=radius, height_m=height):
            return {"kind": "cylinder", "radius_m": radius, "height_m": height}
        case Ball(radius_m=radius):
            return {"kind": "ball", "radius_m": radius}
