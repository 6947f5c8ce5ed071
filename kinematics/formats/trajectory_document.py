"""A trajectory as text: the JSON document of docs/reference/trajectory.schema.json.

Read strictly: whatever is missing, unknown, doubled, not finite or out of all proportion is an error
that names its place. Written exactly: times, configurations and velocities come back bit by bit.
"""

from __future__ import annotations

import json
from dataclasses import dataclass

import numpy as np

from kinematics.formats.json_reader import Node, parse_document
from kinematics.formats.solid_document import (
    MAX_ENTRIES,
    MAX_POSITION,
    MAX_SIZE_M,
    HeldObject,
    held_json,
    object_json,
    optional_items,
    pose_json,
    read_held,
    read_object,
    read_pair,
    read_pose,
    require_unique,
)
from kinematics.model.stance import Stance
from kinematics.motion.trajectory import Trajectory
from kinematics.scene.concessions import Concession, ConcessionReason
from kinematics.scene.planning_scene import Pair, SceneObject

SCHEMA = 1
MAX_SAMPLES = 100_000
MAX_JOINTS = 1_000
MAX_DURATION_S = 600.0
"""Ten minutes: the work of a check grows with the duration."""
MIN_SPACING_S = 1e-6
"""Nearer samples are no motion of any machine, and their differences drown in rounding."""
MAX_VELOCITY = 1e4
"""Bound of plausibility, per second, as that of positions."""
LEAST_QUATERNION = 0.1
"""A base quaternion shorter than this has no direction; one that is not quite 1 is the checker's to find."""

_BASE_Q = tuple(f"base {axis}" for axis in "xyz") + tuple(f"base quaternion {axis}" for axis in "xyzw")
_BASE_V = tuple(f"base {kind} {axis}" for kind in ("velocity", "angular velocity") for axis in "xyz")


@dataclass(frozen=True, slots=True)
class StoredTrajectory:
    """What a document holds; nothing in it has been compared with a robot yet.

    Attributes:
        robot: Name of the robot that the motion is made for.
        trajectory: The motion, in the world frame of its scene.
        held: What the robot carries meanwhile.
        allowed: Pairs of names (links, objects) that may touch.
        objects: What is around, in the trajectory's frame; None when the document does not say.
        concessions: What the motion's planner asks the checker to overlook.
    """

    robot: str
    trajectory: Trajectory
    held: tuple[HeldObject, ...] = ()
    allowed: frozenset[Pair] = frozenset()
    objects: tuple[SceneObject, ...] | None = None
    concessions: tuple[Concession, ...] = ()


def write_trajectory(stored: StoredTrajectory) -> str:
    """The document, one line a sample."""
    motion = stored.trajectory
    head: dict[str, object] = {
        "schema": SCHEMA,
        "robot": stored.robot,
        "joints": list(motion.joints),
        "stance": {frame: pose_json(world_T_sole) for frame, world_T_sole in motion.stance.soles},
    }
    if stored.held:
        head["held"] = [held_json(item) for item in stored.held]
    if stored.allowed:
        head["allowed"] = sorted(sorted(pair) for pair in stored.allowed)
    if stored.concessions:
        head["concessions"] = [concession_json(one) for one in stored.concessions]
    if stored.objects is not None:
        head["objects"] = [object_json(item) for item in stored.objects]
    samples = ",\n".join(
        json.dumps({"t_s": t_s, "q": q, "v": v})
        for t_s, q, v in zip(motion.t_s.tolist(), motion.q.tolist(), motion.v.tolist(), strict=True)
    )
    lines = [f"{json.dumps(key)}: {json.dumps(value)}" for key, value in head.items()]
    return "{" + ",\n".join([*lines, f'"samples": [\n{samples}\n]']) + "}\n"


def read_trajectory(text: str) -> StoredTrajectory:
    """Read a document.

    Args:
        text: JSON, as ``docs/reference/trajectory.schema.json`` describes it.

    Raises:
        TrajectoryDocumentError: With the place, such as ``samples[12].q[9] (arm_left_3_joint)``, and
            the reason.
    """
    root = parse_document(text)
    root.only(
        ("schema", "robot", "joints", "stance", "samples"), ("held", "allowed", "objects", "concessions")
    )
    schema = root.key("schema")
    if type(schema.value) is not int or schema.value != SCHEMA:  # JSON's true and 1.0 equal 1 too
        raise schema.error(f"must be {SCHEMA}, not {schema.shown()}")
    robot = root.key("robot").text()
    joints = tuple(item.text() for item in root.key("joints").items(0, MAX_JOINTS))
    require_unique(root, "joints", joints)
    soles = tuple((frame, read_pose(node)) for frame, node in root.key("stance").entries(MAX_ENTRIES))
    motion = _motion(root.key("samples"), joints, Stance(soles))
    held = tuple(read_held(node) for node in optional_items(root, "held"))
    require_unique(root, "held", [item.name for item in held])
    pairs = frozenset(read_pair(node) for node in optional_items(root, "allowed"))
    concessions = tuple(read_concession(node) for node in optional_items(root, "concessions"))
    if not root.has("objects"):
        return StoredTrajectory(robot, motion, held, pairs, concessions=concessions)
    objects = tuple(read_object(node) for node in optional_items(root, "objects"))
    require_unique(root, "objects", [item.name for item in objects])
    return StoredTrajectory(robot, motion, held, pairs, objects, concessions)


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


_REASONS = tuple(reason.value for reason in ConcessionReason)


def concession_json(one: Concession) -> dict[str, object]:
    """What ``read_concession`` reads."""
    found: dict[str, object] = {"pair": list(one.names), "reason": one.reason.value, "step": one.step}
    if one.distance_m is not None:
        found["distance_m"] = one.distance_m
    return found


def read_concession(node: Node) -> Concession:
    """A concession; what it may concede is the checker's to say.

    Raises:
        TrajectoryDocumentError: It is none; with its place.
    """
    node.only(("pair", "reason", "step"), ("distance_m",))
    distance_m = node.key("distance_m").number(MAX_SIZE_M) if node.has("distance_m") else None
    if distance_m is not None and distance_m < 0.0:
        raise node.key("distance_m").error(f"must be 0 or more, not {distance_m!r}")
    return Concession(
        pair=read_pair(node.key("pair")),
        reason=ConcessionReason(node.key("reason").choice(_REASONS)),
        step=node.key("step").text(),
        distance_m=distance_m,
    )
