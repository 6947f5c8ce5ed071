"""The executive's connection to the control process: what it hears, and what it may say."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import robots.control.events as control_events
from kinematics.robot_model import RobotModel
from kinematics.trajectory import Finding, FindingKind, Unsafe
from robots.clock import WallClock
from robots.control.emergency_stop import EmergencyStop
from robots.control.events import ControlEvent
from robots.control.motion_handle import MotionHandle, MotionStatus
from robots.live.connection import Connection
from robots.live.errors import LiveError, ProtocolError
from robots.live.frame_message import read_frame
from robots.live.framing import FrameKind
from robots.live.messages import (
    Admit,
    CancelMotion,
    Guarded,
    Heartbeat,
    Hello,
    Start,
    Stop,
    read_object,
    write_control_message,
)
from robots.live.robot_report import ReportLayout, RobotReport
from robots.live.runtime_folder import RuntimeFolder
from robots.live.state_slot import StateSlotReader
from robots.live.unix_socket import connect_to
from robots.perception.detector import PerceptionFrame

_ANSWER_WITHIN_S = 10.0
"""Wall time in which a greeting is answered; the machine may be busy."""

_KEPT_VERDICTS = 64


class ControlLostError(LiveError):
    """The connection to the control process ended."""


class AttachRefusedError(LiveError):
    """The control process does not take this process as its commander."""


Verdict = bool | Unsafe | str
"""Admitted, unsafe, or why it was not judged."""


class ControlLink:
    """A commander's connection.

    Attributes:
        about: What the control process said of itself: robot, scene, seed, period.
        report: The newest state of the robot.
        emergency: The emergency stop that is engaged, or None.
        defects, reservations: What is wrong with the robot, so that it must not move, or takes no new task.
        frame: The newest perception frame, or None.
        verdicts: Of trajectories by their number, as they come.
        lost: Why the connection ended, or empty.
    """

    def __init__(self, folder: RuntimeFolder, model: RobotModel) -> None:
        """Attach as the commander.

        Raises:
            NotServedError: No control process listens there.
            AttachRefusedError: It has a commander, or does not answer.
            ProtocolError: It serves another robot.
        """
        self._wall = WallClock()
        self._connection = Connection(connect_to(folder.control_socket))
        self._number = 0
        self._motions: dict[int, MotionHandle] = {}
        self._listen: Callable[[ControlEvent], None] = lambda _event: None
        self.frame: PerceptionFrame | None = None
        self.verdicts: dict[int, Verdict] = {}
        self.emergency: EmergencyStop | None = None
        self.defects: tuple[str, ...] = ()
        self.reservations: tuple[str, ...] = ()
        self.lost = ""
        self.about: Mapping[str, Any] = {}
        self._connection.send(write_control_message(Hello("commander")))
        self._await_welcome()
        self._layout = ReportLayout(model)
        self._slot = StateSlotReader(Path(str(self.about["slot"])))
        row = self._slot.newest()
        if row is None:
            raise ProtocolError("the state slot is empty")
        self.report: RobotReport = self._layout.report(row)

    @property
    def now_s(self) -> float:
        """Control time, as of the newest state."""
        return self.report.t_s

    def listen(self, call: Callable[[ControlEvent], None]) -> None:
        """Have the control layer's events told."""
        self._listen = call

    def poll(self, wait_s: float = 0.0) -> bool:
        """Take in what has arrived; tells whether the robot's state is a new one.

        Args:
            wait_s: Wait for a message for so long, of wall time.

        Raises:
            ControlLostError: The connection has ended.
        """
        if wait_s > 0.0 and not self._connection.more:
            self._connection.wait(wait_s)
        self._connection.flush()
        self._receive()
        if self._connection.closed:
            self._lose()
        row = self._slot.newest()
        if row is None:
            return False
        self.report = self._layout.report(row)
        return True

    def close(self) -> None:
        """End the connection; whatever moves is braked by the other side."""
        self._connection.close("")
        self._slot.close()

    # ---------------------------------------------------------------- what a commander may say

    def beat(self, busy: bool, looking: bool, world_version: int) -> None:
        """Send the heartbeat of one tick."""
        self._say(Heartbeat(self._next(), self.now_s, busy, looking, world_version))

    def admit(self, trajectory: int, world_version: int, document: str) -> None:
        """Ask for a trajectory to be checked by the other side; the verdict comes later."""
        head = write_control_message(Admit(self._next(), self.now_s, trajectory, world_version))
        self._connection.send(head + b"\n" + document.encode(), FrameKind.DOCUMENT)

    def start(self, handle: MotionHandle, motion: int, trajectory: int) -> None:
        """Start an admitted trajectory; the handle follows what becomes of it."""
        self._motions[motion] = handle
        self._say(Start(self._next(), self.now_s, motion, trajectory))

    def start_guarded(self, handle: MotionHandle, motion: int, name: str, hand: str) -> None:
        """Start a guarded motion that the other side makes."""
        self._motions[motion] = handle
        self._say(Guarded(self._next(), self.now_s, motion, name, hand))

    def cancel(self, handle: MotionHandle, reason: str) -> None:
        """Brake a motion and hold."""
        for number, known in self._motions.items():
            if known is handle:
                self._say(CancelMotion(self._next(), number, reason[:500]))

    def stop(self, category: int, reason: str) -> None:
        """Engage the emergency stop."""
        self._connection.send(write_control_message(Stop(category, reason[:500])))

    # ---------------------------------------------------------------- inside

    def _next(self) -> int:
        self._number += 1
        return self._number

    def _say(self, message: Heartbeat | Start | Guarded | CancelMotion) -> None:
        self._connection.send(write_control_message(message))

    def _await_welcome(self) -> None:
        until_s = self._wall.now_s() + _ANSWER_WITHIN_S
        while not self.about:
            left_s = until_s - self._wall.now_s()
            if left_s <= 0.0:
                raise AttachRefusedError("the control process does not answer")
            self._connection.wait(left_s)
            self._receive()
            if self._connection.closed and not self.about:
                raise AttachRefusedError(self.lost or "the control process ended the connection")

    def _receive(self) -> None:
        while not self._connection.closed:
            frames = self._connection.receive()
            for frame in frames:
                self._take(read_object(frame.payload))
            if not frames:
                return

    def _take(self, message: Mapping[str, Any]) -> None:
        match message["type"]:
            case "welcome":
                self.about, self.emergency = message, _emergency(message["emergency"])
                self._note_health(message["health"])
            case "health":
                self._note_health(message)
            case "emergency":
                self.emergency = _emergency(message)
            case "motion":
                self._follow(message)
            case "frame":
                self.frame = read_frame(message)
            case "event":
                event = _event(message)
                if event is not None:
                    self._listen(event)
            case "admitted" | "unsafe" | "rejected":
                self._note_verdict(message)
            case "refused" | "error":
                self.lost = self.lost or str(message["reason"])
            case _:
                pass

    def _note_health(self, values: Mapping[str, Any]) -> None:
        self.defects = tuple(map(str, values["defects"]))
        self.reservations = tuple(map(str, values["reservations"]))

    def _note_verdict(self, message: Mapping[str, Any]) -> None:
        verdict: Verdict = True
        if message["type"] == "unsafe":
            verdict = Unsafe(tuple(map(_finding, message["findings"])))
        elif message["type"] == "rejected":
            verdict = str(message["reason"])
        self.verdicts[message["trajectory"]] = verdict
        while len(self.verdicts) > _KEPT_VERDICTS:  # of jobs that nobody asks for any more
            del self.verdicts[next(iter(self.verdicts))]

    def _follow(self, message: Mapping[str, Any]) -> None:
        handle = self._motions.get(message["motion"])
        if handle is None:
            return
        handle.progress = float(message["progress"])
        status = MotionStatus(message["status"])
        if status is not MotionStatus.RUNNING:
            del self._motions[message["motion"]]
            if not handle.finished:
                handle.reason = str(message["reason"])
                handle.status = status

    def _lose(self) -> None:
        self.lost = self.lost or "the control process ended the connection"
        for handle in self._motions.values():
            handle.status, handle.reason = MotionStatus.CANCELED, self.lost
        self._motions.clear()
        raise ControlLostError(self.lost)


def _emergency(values: Mapping[str, Any]) -> EmergencyStop | None:
    if not values["engaged"]:
        return None
    return EmergencyStop(float(values["t_s"]), int(values["category"]), str(values["engaged"]))


def _event(message: Mapping[str, Any]) -> ControlEvent | None:
    """The control layer's event of a message; None for one that this side does not know."""
    kind = getattr(control_events, str(message["event"]), None)
    values = {key: value for key, value in message.items() if key not in ("type", "event")}
    try:
        event: ControlEvent | None = None if kind is None else kind(**values)
    except TypeError:
        return None
    return event


def _finding(values: list[Any]) -> Finding:
    kind, t_s, subject, value, limit = values
    return Finding(FindingKind(kind), float(t_s), tuple(map(str, subject)), float(value), float(limit))
