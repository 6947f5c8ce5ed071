"""What the robot believes to be around it, as detections of ROS 2."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from executive.doors.ros.messages import (
    BoundingBox3D,
    Detection3D,
    Detection3DArray,
    Header,
    ObjectHypothesis,
    ObjectHypothesisWithPose,
    Point,
    Pose,
    PoseWithCovariance,
    Quaternion,
    Time,
    Vector3,
)
from executive.doors.ros.publishing import ODOM


def believed(world: Mapping[str, Any], stamp: Time) -> Detection3DArray:
    """What is believed, each thing in the frame that carries it, or in ``odom``.

    Covariances hold the variances of places, m2, where a look of this task told any.

    Args:
        world: As the executive tells it (``world`` of docs/reference/live-protocol.md).
        stamp: When it was so.
    """
    return Detection3DArray(Header(stamp, ODOM), [_thing(one, stamp) for one in world["things"]])


def _thing(one: Mapping[str, Any], stamp: Time) -> Detection3D:
    pose = Pose(Point(*map(float, one["place_m"])), Quaternion(*map(float, one["quaternion"])))
    covariance = [0.0] * 36
    for axis, error_m in enumerate(one.get("error_m", ())):
        covariance[7 * axis] = float(error_m) ** 2
    kind, confidence = str(one.get("kind") or one["is"]), float(one.get("confidence", 1.0))
    guess = ObjectHypothesisWithPose(ObjectHypothesis(kind, confidence), PoseWithCovariance(pose, covariance))
    frame = str(one.get("held") or ODOM)
    return Detection3D(Header(stamp, frame), [guess], BoundingBox3D(pose, _size(one)), str(one["name"]))


def _size(one: Mapping[str, Any]) -> Vector3:
    """Edges of the box around a solid, m."""
    size = [float(value) for value in one["size_m"]]
    match one["shape"]:
        case "box":
            return Vector3(*size)
        case "cylinder":
            return Vector3(2.0 * size[0], 2.0 * size[0], size[1])
        case _:
            return Vector3(*[2.0 * size[0]] * 3)
