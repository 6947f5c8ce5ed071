"""Where a hand pushes something shut: against its front, from outside, with whatever of the hand comes first.

An open door stands edge-on before the robot, with its handle on the far side: often out of sight, and
always at an awkward angle for fingers; the bar of an open drawer may be nearer than a short arm can have it.
A push needs neither, and the hand may turn as it likes.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator
from typing import Any

import coal
import numpy as np
import pinocchio as pin

from kinematics.arrays import Array
from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel
from kinematics.planning.grasps import key_of
from kinematics.requests.grasp import Grasp
from kinematics.requests.handle import HandleRequest
from kinematics.scene.opening_path import UP, DoorArc
from kinematics.scene.planning_scene import SceneObject

APPROACH_M = 0.07
_FOLLOWED, _KEPT = (0.8, 0.6, 1.0, 0.4), (1.0, 0.8)
"""Of the door's angle: the hand is turned by so much less than square to the front; and of one that keeps its
heading, whose fingertips would come behind the bar if it pointed to the free edge when the door is shut."""
_MORE_RAD, _EVERY_RAD = 0.5, 0.01
"""A hand that keeps its heading is led by at most so much farther than the door, looked for in such steps."""
_TURNS_RAD, _PALM_TURNS_RAD = (0.0,), (0.0, 0.5, -0.3, 1.0)
"""So far the left hand is turned from pointing at what it pushes; a palm may look at it."""
_ASIDE, _HIGH = (0.35, -0.35), (0.0, 0.2, -0.2)
"""Of a drawer's width and height: so far beside the middle of the front, where its bar is."""
_OFF_EDGE_M = 0.08
"""A hand pushes no nearer to a door's upper edge than this."""
_BAR_DEPTH_M, _BAR_WIDE_M, _BAR_INSET_M, _BAR_BOTTOM_M = 0.07, 0.08, 0.07, 0.75
_BAR_TOPS_M = (1.30, 1.25, 1.20)
"""Where a bar can be that is not seen: so far out, so wide about so far from the free edge, so high."""


def outward_of(request: HandleRequest) -> Array:
    """Horizontal unit vector square to the front, to the side that a push comes from, shape (3,)."""
    path = request.path
    if not isinstance(path, DoorArc):
        return path.at(request.s_from).outward
    yaw = path.closed_yaw_rad - path.side * request.s_from
    return np.array([-math.cos(yaw), -math.sin(yaw), 0.0])


def push_grasps(model: RobotModel, request: HandleRequest) -> Iterator[Grasp]:
    """Poses of the hand that touches the front from outside, the most promising first."""
    front, outward = request.scene.objects[request.pushed], outward_of(request)
    if not isinstance(front.shape, Box):
        return
    inward_yaw, thickness_m = math.atan2(-outward[1], -outward[0]), front.shape.size_m[0]
    for hand in request.hands:
        points, sign = hand_points(model, hand, request.q_start), 1.0 if hand == "left" else -1.0
        palm = model.description.grippers[hand].palm_side_m is not None
        for turn in _PALM_TURNS_RAD if palm else _TURNS_RAD:
            for label, place, turned in _places(model, request, outward, front, front.shape):
                label = f"{label}{f' wrist {math.degrees(turn):+.0f}' if turn else ''}"
                if key_of(hand, label) in request.excluded:
                    continue
                rotation = poses.rotation_z(inward_yaw + turned + sign * turn)
                around = points @ rotation.T
                inwards = around @ -outward
                at = place + (0.5 * thickness_m + float(np.max(inwards))) * outward
                if not isinstance(request.path, DoorArc):  # near its edge: what comes first is to be there
                    across = request.path.at(request.s_from).across
                    at = at - around[np.argmax(inwards)] @ across * across
                yield Grasp(hand, label, poses.transform(rotation, at), APPROACH_M, 0.0)


def shut_at(model: RobotModel, request: HandleRequest, grasp: Grasp) -> float:
    """Where on the hand's own path what it pushes is as far shut as the request wants it, rad or m.

    Of a hand that keeps its heading one part after another comes first while the door turns: the door is not
    where the hand is on its arc.
    """
    path, front = request.path, request.scene.objects[request.pushed]
    kept = model.description.pushing.heading_weight is not None
    if not isinstance(path, DoorArc) or not isinstance(front.shape, Box) or not kept:
        return request.s_to
    closed = poses.rotation_z(path.closed_yaw_rad)
    hand = hand_points(model, grasp.hand, request.q_start) @ grasp.world_T_tcp[:3, :3].T
    way = path.through(grasp.world_T_tcp[:3, 3], request.s_from)
    openings = np.arange(request.s_from, request.s_to - _MORE_RAD, -_EVERY_RAD)
    # (openings, points of the hand, 2): out from the hinge along the closed door, and before it
    places = np.array([way.at(float(s)).position_m for s in openings])[:, None] + hand - [*path.hinge_m, 0.0]
    along, before = -path.side * (places @ closed[:, 1]), -(places @ closed[:, 0])
    radius = np.hypot(along, before)
    met = np.arctan2(before, along) - np.arcsin(np.clip(0.5 * front.shape.size_m[0] / radius, -1.0, 1.0))
    met[radius > front.shape.size_m[1]] = np.inf  # beside its free edge
    shut = np.flatnonzero(met.min(axis=1) <= request.s_to)
    return float(openings[shut[0] if len(shut) else -1])


def _places(
    model: RobotModel, request: HandleRequest, outward: Array, front: SceneObject, shape: Box
) -> Iterator[tuple[str, Array, float]]:
    """Names of places to push at, points of the front's middle plane, and how far a hand is turned there."""
    path, (_, width_m, height_m) = request.path, shape.size_m
    if not isinstance(path, DoorArc):
        across, middle = path.at(request.s_from).across, front.world_T_object[:3, 3]
        for aside, high in itertools.product(_ASIDE, _HIGH):
            place = middle + aside * width_m * across + high * height_m * UP
            yield f"push at {aside * width_m:+.2f} {place[2]:.2f}", place, 0.0
        return
    pushing = model.description.pushing
    # an oven is less high than a fridge
    low_m, high_m = front.world_T_object[2, 3] + (0.5 * height_m - _OFF_EDGE_M) * np.array([-1.0, 1.0])
    for away_m, at_m in pushing.places_m:
        if away_m > width_m:
            continue
        up_m = float(np.clip(at_m, low_m, high_m))
        place = np.array([*path.hinge_m, up_m]) + away_m * _along(path, outward)
        for followed in _FOLLOWED if pushing.heading_weight is None else _KEPT:
            label = f"push at {away_m:.2f} {up_m:.2f} turned {followed:.1f}"
            yield label, place, path.side * followed * request.s_from


def _along(path: DoorArc, outward: Array) -> Array:
    """Unit vector from the hinge to the free edge, shape (3,)."""
    return np.asarray(path.side * np.array([-outward[1], outward[0], 0.0]))


def assumed_bars(request: HandleRequest) -> Iterator[SceneObject]:
    """Where the bar of a front may be that is out of sight, the longest first; none where it is known.

    Bars of household doors stand off by up to 7 cm, near the free edge, between hip and chest. Where the
    hand is already, no bar is: that one ends below it.
    """
    front, path = request.scene.objects.get(request.pushed), request.path
    if front is None or request.handle != request.pushed or not isinstance(front.shape, Box):
        return
    if not isinstance(path, DoorArc):
        return
    outward = outward_of(request)
    thickness_m, width_m, _ = front.shape.size_m
    pose = front.world_T_object.copy()
    pose[:2, 3] = path.hinge_m
    pose[:3, 3] += (width_m - _BAR_INSET_M) * _along(path, outward)
    pose[:3, 3] += 0.5 * (thickness_m + _BAR_DEPTH_M) * outward
    for top_m in _BAR_TOPS_M:
        bar = pose.copy()
        bar[2, 3] = 0.5 * (_BAR_BOTTOM_M + top_m)
        shape = Box((_BAR_DEPTH_M, _BAR_WIDE_M, top_m - _BAR_BOTTOM_M))
        yield SceneObject(f"{request.pushed} handle", shape, bar, movable=False)


def hand_points(model: RobotModel, hand: Hand, q: Array) -> Array:
    """Corners of the hand's collision shapes in its TCP frame, shape (n, 3); the fingers are as in ``q``."""
    gripper, geometry = model.description.grippers[hand], model.geometry()
    data, placed = model.pin.createData(), geometry.createData()
    pin.updateGeometryPlacements(model.pin, data, geometry, placed, q)
    tcp_T_world = poses.inverse(model.frame_pose(q, gripper.tcp_frame))
    found = []
    for item, pose in zip(geometry.geometryObjects, placed.oMg, strict=True):
        if model.link_of(item) in gripper.touch_links:
            corners = corners_of(item.geometry)
            at = tcp_T_world @ pose.homogeneous
            found.append(corners @ at[:3, :3].T + at[:3, 3])
    return np.concatenate(found)


def corners_of(geometry: Any) -> Array:
    """Of a hull or a box of Coal's; around a cylinder those of the box that it is in; shape (n, 3)."""
    if isinstance(geometry, coal.ConvexBase):
        return np.asarray(geometry.points())
    half = (
        np.array([geometry.radius, geometry.radius, geometry.halfLength])
        if isinstance(geometry, coal.Cylinder)
        else np.array(geometry.halfSide)
    )
    return np.asarray(half * np.array(list(itertools.product((-1.0, 1.0), repeat=3))), dtype=np.float64)
