"""Writes down one run: each thing that is told of it becomes a message at its topic.

Times are control time, counted from the wall time at which control time was zero. Numbers that ROS has
messages for are written as these; what it has none for, the tree, events and beliefs, as JSON in a
``std_msgs/String``, and the whole row of the state slot as a ``std_msgs/Float64MultiArray``, so that a run
is shown again as it was.
"""

from __future__ import annotations

import io
import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from PIL import Image as Pictures

from executive.doors.recorder.believed import believed
from executive.doors.recorder.mcap_log import McapLog
from executive.doors.ros.camera import camera_info
from executive.doors.ros.messages import Header, String, Time
from executive.doors.ros.publishing import StateMessages, diagnostics
from executive.doors.ros.recorded_messages import (
    INFO,
    WARNING,
    CompressedImage,
    Float64MultiArray,
    Log,
    MultiArrayDimension,
    MultiArrayLayout,
)
from kinematics.arrays import Array
from kinematics.model.robot_model import RobotModel
from robots.clock import utc_ns
from robots.live.documents.robot_report import ReportLayout
from robots.perception.rgbd.picture_slot import ShownPicture

STATE, TREE, EVENTS, WORLD = "/executive/state", "/executive/tree", "/executive/events", "/executive/world"
PICTURES = "/camera/color/image_raw/compressed"
_EVERY_S: Mapping[str, float] = {"joints": 0.01, "row": 0.02, "body": 0.02, "frames": 0.05}
"""Control time between two messages of a kind; a state that comes a little early counts as due."""
_EARLY = 0.9
_NS = 1_000_000_000
_JPEG_QUALITY = 85


class Recorder:
    """Records one run.

    Args:
        path: Of the MCAP file; it is not there yet.
        model: The robot.
        about: Whose run it is: what the file's metadata tell.
        zero_ns: Wall time since 1970 at which control time was zero; None where it goes on as this begins.

    Raises:
        OSError: The file cannot be made; as every other method where it cannot be written.
    """

    def __init__(
        self, path: Path, model: RobotModel, about: Mapping[str, str], zero_ns: int | None = None
    ) -> None:
        self._messages, self._layout = StateMessages(model.description), ReportLayout(model)
        self._robot = model.description
        self._log, self._zero_ns = McapLog(path, about), zero_ns
        self._due_s = dict.fromkeys(_EVERY_S, float("-inf"))
        self._begun = False
        self._told: dict[str, str] = {}
        self._row = MultiArrayLayout([MultiArrayDimension("row", self._layout.count, self._layout.count)], 0)

    def state(self, row: Array) -> None:
        """Record a state of the robot, as the state slot holds it."""
        report = self._layout.report(row)
        at_ns, stamp = self._at(report.t_s)
        messages, log = self._messages, self._log
        if not self._begun:
            self._begun = True
            log.write("/robot_description", String(self._robot.urdf), at_ns)
            log.write("/tf_static", messages.fixed_transforms(stamp), at_ns)
        if self._is_due("joints", report.t_s):
            log.write("/joint_states", messages.joints(report, stamp), at_ns)
        if self._is_due("row", report.t_s):
            log.write(STATE, Float64MultiArray(self._row, row.tolist()), at_ns)
        if self._is_due("body", report.t_s):
            log.write("/odom", messages.odometry(report, stamp), at_ns)
            if (imu := messages.imu(report, stamp)) is not None:
                log.write("/imu", imu, at_ns)
            for wrench in messages.wrenches(report, stamp):
                log.write(f"/wrench/{wrench.header.frame_id}", wrench, at_ns)
        if self._is_due("frames", report.t_s):
            log.write("/tf", messages.transforms(report, stamp), at_ns)

    def event(self, told: Mapping[str, Any], line: str | None) -> None:
        """Record an event, with its line for people."""
        at_ns, stamp = self._at(float(told.get("t_s", 0.0)))
        self._log.write(EVENTS, String(json.dumps({"told": told, "line": line})), at_ns)
        if line:
            level = WARNING if told.get("failure") else INFO
            self._log.write("/rosout", Log(stamp, level, "executive", line), at_ns)

    def tree(self, t_s: float, nodes: Sequence[Mapping[str, Any]]) -> None:
        """Record the tree, where it has changed."""
        if (text := self._changed(TREE, nodes)) is not None:
            self._log.write(TREE, String(text), self._at(t_s)[0])

    def world(self, t_s: float, world: Mapping[str, Any]) -> None:
        """Record what is believed, where it has changed."""
        if (text := self._changed(WORLD, world)) is not None:
            at_ns, stamp = self._at(t_s)
            self._log.write(WORLD, String(text), at_ns)
            self._log.write("/detections", believed(world, stamp), at_ns)

    def status(self, t_s: float, told: Mapping[str, Any]) -> None:
        """Record how control and executive stand."""
        at_ns, stamp = self._at(t_s)
        self._log.write("/diagnostics", diagnostics(told, self._robot, stamp), at_ns)

    def picture(self, shown: ShownPicture) -> None:
        """Record a picture of the robot's camera."""
        at_ns, stamp = self._at(shown.stamp_s)
        file = io.BytesIO()
        Pictures.fromarray(shown.color).save(file, "JPEG", quality=_JPEG_QUALITY)
        data: Any = file.getvalue()
        picture = CompressedImage(Header(stamp, shown.frame), "rgb8; jpeg compressed bgr8", data)
        self._log.write(PICTURES, picture, at_ns)
        self._log.write("/camera/color/camera_info", camera_info(shown, stamp), at_ns)

    def close(self) -> None:
        """End the file."""
        self._log.close()

    def _at(self, t_s: float) -> tuple[int, Time]:
        """An instant of control time as wall time: nanoseconds since 1970, and as ROS writes it."""
        if self._zero_ns is None:
            self._zero_ns = utc_ns() - round(t_s * _NS)
        at_ns = self._zero_ns + round(t_s * _NS)
        return at_ns, Time(*divmod(at_ns, _NS))

    def _is_due(self, what: str, t_s: float) -> bool:
        every_s = _EVERY_S[what]
        if t_s < self._due_s[what]:
            return False
        self._due_s[what] = t_s + _EARLY * every_s
        return True

    def _changed(self, topic: str, value: object) -> str | None:
        """A value as JSON; None where it is as it was told last."""
        text = json.dumps(value)
        if self._told.get(topic) == text:
            return None
        self._told[topic] = text
        return text
