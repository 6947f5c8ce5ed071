"""A run whose motion was recorded, as something to scrub through: read from its MCAP files."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from mcap.records import Channel, Message, Metadata

from executive.doors.recorder.mcap_log import ABOUT
from executive.doors.recorder.mend import UnreadableRecordingError, records
from executive.doors.recorder.parts import MotionParts
from executive.doors.recorder.recorder import EVENTS, PICTURES, STATE, TREE, WORLD
from executive.doors.ros.messages import String
from executive.doors.ros.recorded_messages import CompressedImage, Float64MultiArray
from executive.doors.view.recording import Moment, Recording
from executive.doors.view.seen import log_line
from executive.runs.run_log import RecordedRun
from kinematics.model.robot_model import RobotModel
from robots.live.documents.robot_report import ReportLayout
from robots.models.description import load_description

_READ = frozenset({EVENTS, PICTURES, STATE, TREE, WORLD})
_NS = 1e9


def recording_of(run: RecordedRun) -> Recording:
    """A run as it was recorded.

    Args:
        run: It; its folder holds its motion.

    Raises:
        UnreadableRecordingError: It does not, or a file of it cannot be read.
    """
    parts = MotionParts(run.path).all()
    if not parts:
        raise UnreadableRecordingError(run.path, "there is no recorded motion")
    return _read(Recording(run), parts)


def recording_in(path: Path) -> Recording:
    """What one MCAP file holds, wherever it is.

    Raises:
        UnreadableRecordingError: It cannot be read, or is not one of a run.
    """
    told = (one for one in records(path) if isinstance(one, Metadata) and one.name == ABOUT)
    about = next((one.metadata for one in told), None)
    if about is None:
        raise UnreadableRecordingError(path, "it does not tell whose run it is")
    return _read(Recording(RecordedRun(path, about, {})), [path])


def _read(recording: Recording, parts: Sequence[Path]) -> Recording:
    layout = ReportLayout(RobotModel(load_description(recording.robot)))
    world: Mapping[str, Any] = {"version": -1, "things": []}
    nodes: Sequence[Mapping[str, Any]] = ()
    for part in parts:
        zero_s: float | None = None
        for topic, at_ns, data in _messages(part):
            if topic == STATE:
                row = np.array(Float64MultiArray.deserialize(data).data)
                zero_s = at_ns / _NS - float(row[0])
                recording.moments.append(Moment(float(row[0]), layout.report(row), world, nodes))
                continue
            if topic == PICTURES:
                if zero_s is not None:  # before the first state there is nothing to show it with
                    seen = bytes(CompressedImage.deserialize(data).data)
                    recording.pictures.append((at_ns / _NS - zero_s, seen))
                continue
            told = json.loads(String.deserialize(data).data)
            if topic == TREE:
                nodes = told
            elif topic == WORLD:
                world = told
            else:
                recording.events.append(told["told"])
                if (line := log_line(told["told"], told["line"])) is not None:
                    recording.log.append(line)
    if not recording.moments:
        raise UnreadableRecordingError(parts[0], "it holds no motion")
    # what was told after the last state belongs to the end
    recording.moments[-1] = replace(recording.moments[-1], world=world, nodes=nodes)
    recording.moments.sort(key=lambda one: one.t_s)
    recording.pictures.sort(key=lambda one: one[0])
    return recording


def _messages(part: Path) -> Iterator[tuple[str, int, bytes]]:
    """Topic, wall time in ns and bytes of each message that is shown again."""
    topics: dict[int, str] = {}
    for one in records(part):
        if isinstance(one, Channel):
            topics[one.id] = one.topic
        elif isinstance(one, Message) and topics.get(one.channel_id) in _READ:
            yield topics[one.channel_id], one.log_time, one.data
