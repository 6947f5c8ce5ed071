"""What the robot knows of itself, as messages of ROS.

Frames are those of REP 105 and REP 120: ``odom``, ``base_link`` below it, and the links of the URDF. Lengths
are metres, angles radians; stamps are the wall time at which a state was read.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from executive.doors.ros.frames import FrameTree
from executive.doors.ros.messages import (
    BoundingBox3D,
    Detection3D,
    Detection3DArray,
    DiagnosticArray,
    DiagnosticStatus,
    Header,
    Imu,
    JointState,
    ObjectHypothesis,
    ObjectHypothesisWithPose,
    Odometry,
    Point,
    Pose,
    PoseWithCovariance,
    Quaternion,
    TFMessage,
    Time,
    Transform,
    TransformStamped,
    Vector3,
    Wrench,
    WrenchStamped,
)
from kinematics.model.robot_description import RobotDescription
from robots.live.documents.robot_report import RobotReport

ODOM, BASE = "odom", "base_link"
_FINE, _WARNING, _ERROR = 0, 1, 2
ESTIMATED = "estimated from the legs' efforts and the IMU"
"""What is told of the wrenches of feet without sensors."""
_UNKNOWN = [-1.0, *[0.0] * 8]


class StateMessages:
    """Makes the messages of one robot's state.

    Args:
        description: The robot.
    """

    def __init__(self, description: RobotDescription) -> None:
        self._description = description
        self._names = list(description.actuated)
        self._tree = FrameTree(description.urdf, self._names)

    def joints(self, report: RobotReport, stamp: Time) -> JointState:
        """Positions, velocities and efforts of every driven joint."""
        read = report.sensed.readings
        return JointState(
            Header(stamp, ""), self._names, read.q.tolist(), read.v.tolist(), read.effort.tolist()
        )

    def odometry(self, report: RobotReport, stamp: Time) -> Odometry:
        """Where the base is by the robot's own estimate."""
        x, y, z, qx, qy, qz, qw = report.sensed.q[:7].tolist()
        pose = Pose(Point(x, y, z), Quaternion(qx, qy, qz, qw))
        return Odometry(Header(stamp, ODOM), self._base, PoseWithCovariance(pose))

    def imu(self, report: RobotReport, stamp: Time) -> Imu | None:
        """What the inertial sensor reads, without an orientation; None where the robot has none."""
        if self._description.imu is None:
            return None
        read = report.sensed.readings
        return Imu(
            Header(stamp, self._description.imu),
            orientation_covariance=_UNKNOWN,
            angular_velocity=Vector3(*read.gyro.tolist()),
            linear_acceleration=Vector3(*read.accelerometer.tolist()),
        )

    def wrenches(self, report: RobotReport, stamp: Time) -> list[WrenchStamped]:
        """What each foot feels, in the order of the robot's soles."""
        made = []
        for sole, row in zip(self._description.soles, report.sensed.readings.foot_wrench, strict=True):
            force, torque = row[:3].tolist(), row[3:].tolist()
            made.append(WrenchStamped(Header(stamp, sole.frame), Wrench(Vector3(*force), Vector3(*torque))))
        return made

    def transforms(self, report: RobotReport, stamp: Time) -> TFMessage:
        """Each link that moves in its parent, and the base in ``odom``."""
        places, turns = self._tree.poses(report.sensed.readings.q)
        made = [
            _transform(parent, child, place, turn, stamp)
            for (parent, child), place, turn in zip(
                self._tree.moving, places.tolist(), turns.tolist(), strict=True
            )
        ]
        base = report.sensed.q[:7].tolist()
        return TFMessage([_transform(ODOM, self._base, base[:3], base[3:], stamp), *made])

    def fixed_transforms(self, stamp: Time) -> TFMessage:
        """Each link that does not move in its parent."""
        return TFMessage([_transform(*one, stamp) for one in self._tree.fixed])

    @property
    def _base(self) -> str:
        return self._description.base_link


def _transform(
    parent: str, child: str, place: Sequence[float], turn: Sequence[float], stamp: Time
) -> TransformStamped:
    return TransformStamped(Header(stamp, parent), child, Transform(Vector3(*place), Quaternion(*turn)))


def diagnostics(status: Mapping[str, Any], robot: RobotDescription, stamp: Time) -> DiagnosticArray:
    """How all stands, from the answer to a status question, and whether the feet have sensors."""
    hardware = robot.name
    defects, reservations = status.get("defects") or (), status.get("reservations") or ()
    emergency = status.get("emergency")
    engaged = emergency if isinstance(emergency, str) else (emergency or {}).get("engaged", "")
    parts = [
        _part("robot", defects, reservations, hardware),
        DiagnosticStatus(
            _ERROR if engaged else _FINE,
            "emergency stop",
            f"engaged: {engaged}" if engaged else "not engaged",
            hardware,
        ),
        DiagnosticStatus(_FINE, "task", str(status.get("task") or "waits for a task"), hardware),
    ]
    if robot.soles:
        told = "measured" if robot.foot_sensors else ESTIMATED
        parts.append(DiagnosticStatus(_FINE, "foot wrenches", told, hardware))
    return DiagnosticArray(Header(stamp, ""), parts)


def _part(name: str, errors: Iterable[str], warnings: Iterable[str], hardware: str) -> DiagnosticStatus:
    wrong, odd = list(map(str, errors)), list(map(str, warnings))
    level = _ERROR if wrong else _WARNING if odd else _FINE
    return DiagnosticStatus(level, name, "; ".join(wrong + odd) or "well", hardware)


def detections(things: Iterable[Mapping[str, Any]], stamp: Time) -> Detection3DArray:
    """What the robot believes to be around it, in the frame ``base_footprint`` below the base.

    The box of a thing is as wide as its footprint and as high as the thing.
    """
    header = Header(stamp, "base_footprint")
    found = []
    for one in things:
        if "place_m" not in one:
            continue
        pose = Pose(Point(*one["place_m"]))
        wide = 2.0 * float(one.get("radius_m", 0.0)) / math.sqrt(2.0)
        size = Vector3(wide, wide, float(one.get("height_m", 0.0)))
        guess = ObjectHypothesisWithPose(
            ObjectHypothesis(str(one.get("kind", "")), float(one.get("confidence", 1.0))),
            PoseWithCovariance(pose),
        )
        found.append(Detection3D(header, [guess], BoundingBox3D(pose, size), str(one["name"])))
    return Detection3DArray(header, found)
