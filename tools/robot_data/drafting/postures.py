"""The home posture of a drafted robot: hands ahead with room to move, the weight over the soles."""

from __future__ import annotations

import math

import numpy as np
import pinocchio as pin

from kinematics.arrays import Array
from kinematics.collision.collision_world import CollisionWorld
from kinematics.geometry import poses
from kinematics.model.robot_description import Hand, SoleDescription
from kinematics.model.robot_model import RobotModel
from kinematics.scene.planning_scene import PlanningScene

_CLEAR_M = 0.02
"""What a home posture keeps between links, where it can."""
_ROOM_RAD = 0.05
"""What it keeps from the limits."""
_DRAWN = 800
_LOOKED_AT = 120
"""Of the drawn postures the best are looked at, whether anything touches."""
_STRETCHED = 0.55
"""Of an arm's length: so far from the shoulder a hand has room to all sides."""
_BENDS = (0.06, 0.03, 0.015, 0.005)
"""Of a leg's length: so much lower than with straight knees, the first with which the soles are flat."""
_FLAT = 1e-4
_OFF_THE_END = 0.35
"""Of a sole's length: so far from its ends is the weight, and else as near to the ankle as may be."""
_SEEDS = 24
_STEPS = 80


class NoHomeError(ValueError):
    """No posture was found in which nothing touches.

    Attributes:
        always: Pairs of links that touch in every posture that was looked at.
    """

    def __init__(self, always: frozenset[tuple[str, str]]) -> None:
        self.always = always
        super().__init__("no posture was found that touches nothing")


def home_of(model: RobotModel, rng: np.random.Generator) -> dict[str, float]:
    """Joint positions of a home posture, rad.

    Args:
        model: The robot, with joints at zero as home, and its pairs of links sampled.
        rng: Draws postures.

    Raises:
        NoHomeError: Something touches in every posture.
    """
    q = model.q_home.copy()
    if not model.description.welded:
        q = _stood(model, q, rng)
    for margin_m in (_CLEAR_M, 0.5 * _CLEAR_M, 0.0):
        found = _with_arms(model, q, CollisionWorld(model, PlanningScene(), margin_m, margin_m), rng)
        if found is not None:
            break
    else:
        raise NoHomeError(_always_touching(model, q, rng))
    if not model.description.welded:
        found = _stood(model, found, rng)
    return dict(zip(model.joints, found[7:].tolist(), strict=True))


def _with_arms(model: RobotModel, q: Array, world: CollisionWorld, rng: np.random.Generator) -> Array | None:
    """All arms at once where nothing touches; the second hand mirrors the first one's place."""
    hands = model.description.hands
    found = q.copy()
    mirrored: Array | None = None
    options: list[list[Array]] = []
    for hand in hands[::-1]:
        ranked = _ranked(model, q, hand, mirrored, rng)
        options.append(ranked)
        best = q.copy()
        best[7 + model.group(f"{hand}_arm")] = ranked[0]
        mirrored = model.frame_pose(best, model.description.tcp_frames[hand])[:3, 3] * (1.0, -1.0, 1.0)
    for first in options[0][:_LOOKED_AT]:
        found[7 + model.group(f"{hands[-1]}_arm")] = first
        if len(options) == 1:
            if not world.collides(found):
                return found
            continue
        for second in options[1][: _LOOKED_AT // 10]:
            found[7 + model.group(f"{hands[0]}_arm")] = second
            if not world.collides(found):
                return found
    return None


def _always_touching(model: RobotModel, q: Array, rng: np.random.Generator) -> frozenset[tuple[str, str]]:
    """Pairs that touch whatever the arms do: legs as they stand, the trunk at zero."""
    geometry = model.geometry()
    data, placed = model.pin.createData(), geometry.createData()
    arms = np.concatenate([model.group(f"{hand}_arm") for hand in model.description.hands])
    low, high = np.maximum(model.lower_rad[arms], -math.pi), np.minimum(model.upper_rad[arms], math.pi)
    touching = np.ones(len(geometry.collisionPairs), dtype=np.bool_)
    for _ in range(_LOOKED_AT):
        one = q.copy()
        one[7 + arms] = rng.uniform(low, high)
        pin.computeCollisions(model.pin, data, geometry, placed, one, False)
        touching &= [result.isCollision() for result in placed.collisionResults]
    pairs = (geometry.collisionPairs[int(k)] for k in np.flatnonzero(touching))
    named = ((geometry.geometryObjects[pair.first], geometry.geometryObjects[pair.second]) for pair in pairs)
    return frozenset((min(names), max(names)) for names in (tuple(map(model.link_of, two)) for two in named))


def _ranked(
    model: RobotModel, q: Array, hand: Hand, mirrored: Array | None, rng: np.random.Generator
) -> list[Array]:
    """Postures of an arm, the ones with most room to move first."""
    joints = model.group(f"{hand}_arm")
    low = np.maximum(model.lower_rad[joints] + _ROOM_RAD, -math.pi)
    high = np.minimum(model.upper_rad[joints] - _ROOM_RAD, math.pi)
    middle, half = 0.5 * (low + high), np.maximum(0.5 * (high - low), _ROOM_RAD)
    frame = model.description.tcp_frames[hand]
    link = model.moved_links[model.joints[joints[0]]]
    shoulder = model.frame_pose(q, link)[:3, 3]
    reach = model.description.reach_m / 1.1
    drawn, scores, supple = rng.uniform(low, high, (_DRAWN, len(joints))), [], []
    for posture in drawn:
        one = q.copy()
        one[7 + joints] = posture
        tcp = model.frame_pose(one, frame)
        away = tcp[:3, 3] - shoulder
        jacobian = model.frame_jacobian(one, frame)[:3, 6 + joints]
        supple.append(math.sqrt(max(0.0, float(np.linalg.det(jacobian @ jacobian.T)))))
        score = away[0] / reach - abs(np.linalg.norm(away) / reach - _STRETCHED)
        score -= 0.5 * float(np.mean(((posture - middle) / half) ** 2))
        score += 0.3 * float(tcp[0, 0]) + min(0.0, float(tcp[2, 3]) - 0.15)
        if mirrored is not None:
            score -= 2.0 * float(np.linalg.norm(tcp[:3, 3] - mirrored))
        scores.append(score)
    ranks = np.array(scores) + np.array(supple) / max(max(supple), 1e-9)
    return [drawn[k] for k in np.argsort(-ranks)]


def _stood(model: RobotModel, q: Array, rng: np.random.Generator) -> Array:
    """Legs bent a little, soles flat, the CoM over them; the base is level, and stays where it is."""
    legs = np.concatenate([model.indices(_leg(model, sole)) for sole in model.description.soles])
    straight = q.copy()
    straight[7 + legs] = np.clip(0.0, model.lower_rad[legs] + _ROOM_RAD, model.upper_rad[legs] - _ROOM_RAD)
    for bend in _BENDS:
        found, error = _stood_with(model, straight, bend, rng)
        if error < _FLAT:
            break
    return found


def _stood_with(model: RobotModel, q: Array, bend: float, rng: np.random.Generator) -> tuple[Array, float]:
    """The same with so much of a bend, and by how much a sole is off, m and rad."""
    soles = model.description.soles
    start = [model.frame_pose(q, sole.frame) for sole in soles]
    q, shift, error = q.copy(), np.zeros(3), math.inf
    hips = [model.frame_pose(q, model.moved_links[_leg(model, sole)[0]])[2, 3] for sole in soles]
    lift = bend * float(np.mean([hip - pose[2, 3] for hip, pose in zip(hips, start, strict=True)]))
    for _ in range(6):
        error = 0.0
        for sole, pose in zip(soles, start, strict=True):
            moved = pose[:3, 3] + (shift[0], shift[1], lift)
            goal = poses.transform(poses.rotation_z(poses.yaw_of(pose[:3, :3])), moved)
            q, off = _leg_at(model, q, sole, goal, rng)
            error = max(error, off)
        placed = [model.frame_pose(q, sole.frame) for sole in soles]
        middles = [
            pose[:3, :3] @ np.array([_carrying(sole), float(np.mean(sole.y_m)), 0.0]) + pose[:3, 3]
            for pose, sole in zip(placed, soles, strict=True)
        ]
        shift[:2] += (model.com(q) - np.mean(middles, axis=0))[:2]
    return q, error


def _carrying(sole: SoleDescription) -> float:
    """Where along a sole the weight is: below the ankle, unless that is near an end."""
    low, high = sole.x_m
    room = _OFF_THE_END * (high - low)
    return min(max(0.0, low + room), high - room)


def _leg(model: RobotModel, sole: SoleDescription) -> tuple[str, ...]:
    return model.description.groups[f"{sole.side}_leg"]


def _leg_at(
    model: RobotModel, q: Array, sole: SoleDescription, goal: Array, rng: np.random.Generator
) -> tuple[Array, float]:
    """The leg of a sole with that at a pose, and how far it is off: damped least squares, several starts."""
    joints = model.indices(_leg(model, sole))
    low, high = model.lower_rad[joints] + _ROOM_RAD, model.upper_rad[joints] - _ROOM_RAD
    best, least, off = q, math.inf, math.inf
    for seed in range(_SEEDS):
        one = q.copy()
        spread = 0.6 if seed else 0.0
        one[7 + joints] = np.clip(one[7 + joints] + rng.normal(0.0, spread, len(joints)), low, high)
        for _ in range(_STEPS):
            pose = model.frame_pose(one, sole.frame)
            error = np.concatenate(
                [goal[:3, 3] - pose[:3, 3], poses.vector_from_rotation(goal[:3, :3] @ pose[:3, :3].T)]
            )
            if np.linalg.norm(error) < 1e-7:
                break
            jacobian = model.frame_jacobian(one, sole.frame)[:, 6 + joints]
            step = jacobian.T @ np.linalg.solve(jacobian @ jacobian.T + 1e-6 * np.eye(6), error)
            one[7 + joints] = np.clip(one[7 + joints] + np.clip(step, -0.3, 0.3), low, high)
        cost = float(np.abs(one[7 + joints]).sum()) + 1e4 * float(np.linalg.norm(error))
        if cost < least:
            best, least, off = one, cost, float(np.linalg.norm(error))
        if seed == 0 and np.linalg.norm(error) < 1e-7 and np.any(np.abs(q[7 + joints]) > 0.05):
            break  # it stood nearly so before
    return best, off
