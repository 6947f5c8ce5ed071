"""Where a hand pushes a door shut: against its front, from outside, with whatever of the hand comes first.

An open door stands edge-on before the robot, with its handle on the far side: often out of sight, and
always at an awkward angle for fingers. A push needs neither, and the hand may turn as it likes.
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
from kinematics.errors import InvalidMotionError
from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel
from kinematics.planning.grasps import key_of
from kinematics.requests.grasp import Grasp
from kinematics.requests.handle import HandleRequest
from kinematics.scene.opening_path import DoorArc
from kinematics.scene.planning_scene import SceneObject

APPROACH_M = 0.07
_PLACES_M = ((0.40, 1.05), (0.30, 1.05), (0.48, 1.38), (0.36, 1.25), (0.24, 1.05))
"""Distance from the hinge and height, m: clear of where handles are, far out first; smaller robots push at a
share of both."""
_FOLLOWED = (0.8, 0.6, 1.0, 0.4)
"""Of the door's angle: the hand is turned by so much less than square to the front."""
_BAR_DEPTH_M, _BAR_WIDE_M, _BAR_INSET_M, _BAR_BOTTOM_M = 0.07, 0.08, 0.07, 0.75
_BAR_TOPS_M = (1.30, 1.25, 1.20)
"""Where a bar can be that is not seen: so far out, so wide about so far from the free edge, so high."""


def outward_of(request: HandleRequest) -> Array:
    """Horizontal unit vector square to the front, to the side that a push comes from, shape (3,)."""
    path = request.path
    if not isinstance(path, DoorArc):
        raise InvalidMotionError("only doors are pushed")
    yaw = path.closed_yaw_rad - path.side * request.s_from
    return np.array([-math.cos(yaw), -math.sin(yaw), 0.0])


def push_grasps(model: RobotModel, request: HandleRequest) -> Iterator[Grasp]:
    """Poses of the hand that touches the front from outside, the most promising first."""
    path, s, front = request.path, request.s_from, request.scene.objects[request.pushed]
    outward = outward_of(request)
    if not isinstance(path, DoorArc) or not isinstance(front.shape, Box):
        return
    inward_yaw = math.atan2(-outward[1], -outward[0])
    along = _along(path, outward)
    hinge = np.array([*path.hinge_m, 0.0])
    thickness_m, width_m, _ = front.shape.size_m
    share = model.description.handles.push_share
    for hand in request.hands:
        points = hand_points(model, hand, request.q_start)
        for away_m, height_m in (np.array(_PLACES_M) * share).tolist():
            for followed in _FOLLOWED:
                label = f"push at {away_m:.2f} {height_m:.2f} turned {followed:.1f}"
                if away_m > width_m or key_of(hand, label) in request.excluded:
                    continue
                rotation = poses.rotation_z(inward_yaw + path.side * followed * s)
                stands_off_m = 0.5 * thickness_m + float(np.max(points @ rotation.T @ -outward))
                place = hinge + away_m * along + stands_off_m * outward
                place[2] = height_m
                yield Grasp(hand, label, poses.transform(rotation, place), APPROACH_M, 0.0)


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
            corners = _corners(item.geometry)
            at = tcp_T_world @ pose.homogeneous
            found.append(corners @ at[:3, :3].T + at[:3, 3])
    return np.concatenate(found)


def _corners(geometry: Any) -> Array:
    """Of a hull or a box of Coal's; around a cylinder those of the box that it is in; shape (n, 3)."""
    if isinstance(geometry, coal.ConvexBase):
        return np.asarray(geometry.points())
    half = (
        np.array([geometry.radius, geometry.radius, geometry.halfLength])
        if isinstance(geometry, coal.Cylinder)
        else np.array(geometry.halfSide)
    )
    return np.asarray(half * np.array(list(itertools.product((-1.0, 1.0), repeat=3))), dtype=np.float64)
