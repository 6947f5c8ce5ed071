"""Where a walk goes, as text, and back; the robot's own walking settings are the control side's."""

from __future__ import annotations

import json
from typing import Any

from kinematics.formats.json_reader import Node, parse_document
from kinematics.geometry.planar import PlanarPose
from kinematics.model.walking_settings import WalkingSettings
from kinematics.walking.pattern.gazing import Gazing
from kinematics.walking.pattern.steering import (
    PACE,
    PathSteering,
    Steering,
    StretchSteering,
    TurnSteering,
    VelocitySteering,
)

_MOST_POSES = 2_000
_MOST_M = 1e3
_MOST_SPEED = 10.0
_MOST_RAD = 3.15
_POSE = ("x", "y", "yaw")


def write_steering(steering: Steering) -> str:
    """The document of a steering.

    Raises:
        TypeError: It is of a kind that has no document.
    """
    values: dict[str, Any]
    match steering:
        case VelocitySteering(_, linear_m_s, angular_rad_s, quick):
            values = {"kind": "velocity", "linear_m_s": linear_m_s, "angular_rad_s": angular_rad_s}
            values |= {"quick": True} if quick else {}
        case TurnSteering(_, angular_rad_s, heading_rad):
            values = {"kind": "turn", "angular_rad_s": angular_rad_s, "heading_rad": heading_rad}
        case StretchSteering(_, start, linear_m_s, distance_m):
            values = {"kind": "stretch", "start": _pose_json(start), "linear_m_s": linear_m_s}
            values["distance_m"] = distance_m
        case PathSteering():
            values = {"kind": "path", "path": [_pose_json(pose) for pose in steering.path]}
            values |= {} if steering.pace == PACE else {"pace": steering.pace}
        case Gazing(other, pan_rad, tilt_rad):
            values = json.loads(write_steering(other))
            values["gaze"] = {"pan_rad": pan_rad, "tilt_rad": tilt_rad}
        case _:
            raise TypeError(f"no document for a steering of kind {type(steering).__name__}")
    return json.dumps(values, allow_nan=False)


def read_steering(text: str, settings: WalkingSettings) -> Steering:
    """The steering of a document, for a robot with these settings.

    Raises:
        KinematicsError: It is none; with the place and the reason.
    """
    root = parse_document(text)
    steering = _steps(root, settings)
    if not root.has("gaze"):
        return steering
    gaze = root.key("gaze")
    gaze.only(("pan_rad", "tilt_rad"))
    return Gazing(steering, gaze.key("pan_rad").number(_MOST_RAD), gaze.key("tilt_rad").number(_MOST_RAD))


def _steps(root: Node, settings: WalkingSettings) -> Steering:
    kind = root.key("kind").choice(("velocity", "turn", "stretch", "path"))
    if kind == "velocity":
        root.only(("kind", "linear_m_s", "angular_rad_s"), ("quick", "gaze"))
        linear_m_s = root.key("linear_m_s").number(_MOST_SPEED)
        angular_rad_s = root.key("angular_rad_s").number(_MOST_SPEED)
        quick = root.has("quick") and root.key("quick").truth()
        return VelocitySteering(settings, linear_m_s, angular_rad_s, quick)
    if kind == "turn":
        root.only(("kind", "angular_rad_s", "heading_rad"), ("gaze",))
        angular_rad_s = root.key("angular_rad_s").number(_MOST_SPEED)
        return TurnSteering(settings, angular_rad_s, root.key("heading_rad").number(_MOST_M))
    if kind == "stretch":
        root.only(("kind", "start", "linear_m_s", "distance_m"), ("gaze",))
        return StretchSteering(
            settings,
            _pose(root.key("start")),
            root.key("linear_m_s").number(_MOST_SPEED),
            root.key("distance_m").number(_MOST_M),
        )
    root.only(("kind", "path"), ("pace", "gaze"))
    pace = root.key("pace").number(1.0, positive=True) if root.has("pace") else PACE
    return PathSteering(settings, [_pose(node) for node in root.key("path").items(1, _MOST_POSES)], pace)


def _pose_json(pose: PlanarPose) -> list[float]:
    return [float(pose.x_m), float(pose.y_m), float(pose.yaw_rad)]


def _pose(node: Node) -> PlanarPose:
    x_m, y_m, yaw_rad = node.numbers(_POSE, _MOST_M).tolist()
    return PlanarPose(x_m, y_m, yaw_rad)
