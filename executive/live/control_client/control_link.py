"""The executive's connection to the control process: what it hears, and what it may say."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, TypeVar

from executive.live.control_client.message_values import emergency_of, event_of, finding_of, report_of
from kinematics.model.robot_model import RobotModel
from kinematics.motion.verdict import Unsafe
from robots.clock import WallClock
from robots.control.events import ControlEvent
from robots.control.hands.jogged_body import JogReport
from robots.control.hands.yield_settings import YieldReport
from robots.control.loop.emergency_stop import EmergencyStop
from robots.control.motion_handle import MotionHandle, MotionStatus
from robots.live.documents.frame_message import read_frame
from robots.live.documents.robot_report import ReportLayout, RobotReport
from robots.live.documents.scan_message import RangeScan, read_scan
from robots.live.wire.connection import Connection
from robots.live.wire.errors import LiveError, ProtocolError
from robots.live.wire.framing import FrameKind
from robots.live.wire.messages import (
    Admit,
    BeginJog,
    CancelMotion,
    ControlMessage,
    FinishMotion,
    Guarded,
    Heartbeat,
    Hello,
    Lead,
    Offer,
    Pause,
    Resume,
    Start,
    Steer,
    Stop,
    Walk,
    read_object,
    write_control_message,
)
from robots.live.wire.runtime_folder import RuntimeFolder
from robots.live.wire.state_slot import StateSlotReader
from robots.live.wire.unix_socket import UnixSocket, connect_to
from robots.perception.detector import PerceptionFrame
from robots.perception.fusion.cameras import HEAD

_ANSWER_WITHIN_S = 10.0
"""Wall time in which a greeting is answered; the machine may be busy."""

_KEPT_VERDICTS = 64
_TRIES = 3
_REMEMBERED = 256
"""Commands that may still be refused: those of the last seconds."""


class ControlLostError(LiveError):
    """The connection to the control process ended."""


class AttachRefusedError(LiveError):
    """The control process does not take this process as its commander."""


Verdict = bool | Unsafe | str
"""Admitted, unsafe, or why it was not judged."""

M = TypeVar("M", Start, Guarded, Lead, BeginJog, Walk)


class ControlLink:
    """The connection of a robot's commander to its control process.

    Attributes:
        about: What the control process said of itself: robot, scene, seed, period.
        report: The newest state of the robot.
        emergency: The emergency stop that is engaged, or None.
        defects, reservations: What is wrong with the robot, so that it must not move, or takes no new task.
        frames: The newest perception frame of each camera, by its name.
        scan: The newest range scan, or None.
        verdicts: Of trajectories by their number, as they come.
        lost: Why the connection ended, or empty.
    """

    def __init__(
        self,
        folder: RuntimeFolder,
        model: RobotModel,
        connection: Callable[[UnixSocket], Connection] = Connection,
    ) -> None:
        """Attach as the commander, through a connection of this kind.

        Raises:
            NotServedError: No control process listens there.
            AttachRefusedError: It has a commander, or does not answer.
            ProtocolError: It serves another robot.
        """
        self._wall = WallClock()
        self._connection = connection(connect_to(folder.control_socket))
        self._number = 0
        self._motions: dict[int, MotionHandle] = {}
        self._felt: dict[int, Callable[[YieldReport], None]] = {}
        self._jogged: dict[int, Callable[[JogReport], None]] = {}
        self._refusals: OrderedDict[int, Callable[[str], None]] = OrderedDict()
        self._judged_by: dict[int, int] = {}
        self._listen: Callable[[ControlEvent], None] = lambda _event: None
        self.frames: dict[str, PerceptionFrame] = {}
        self.scan: RangeScan | None = None
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

    def beat(self, busy: bool, looking: bool, ranging: bool, world_version: int) -> None:
        """Send the heartbeat of one tick."""
        self._say(Heartbeat(self._next(), self.now_s, busy, looking, ranging, world_version))

    def admit(self, trajectory: int, world_version: int, document: str, tries: int = _TRIES) -> None:
        """Ask for a trajectory to be checked by the other side; the verdict comes later.

        One that was lost, or came too late to be looked at, is sent again; nothing moves because of it.
        """
        message = Admit(self._next(), self.now_s, trajectory, world_version)

        def refused(reason: str) -> None:
            if tries > 1:
                self.admit(trajectory, world_version, document, tries - 1)
            else:
                self._note_verdict({"type": "rejected", "trajectory": trajectory, "reason": reason})

        self._judged_by[trajectory] = message.number
        self._when_refused(message.number, refused)
        self._say(message, document)

    def start(self, handle: MotionHandle, motion: int, trajectory: int) -> None:
        """Start an admitted trajectory; the handle follows what becomes of it."""
        self._say(self._begin(handle, motion, Start(self._next(), self.now_s, motion, trajectory)))

    def start_guarded(
        self, handle: MotionHandle, motion: int, name: str, hand: str, opening_m: float
    ) -> None:
        """Start a guarded motion that the other side makes."""
        message = Guarded(self._next(), self.now_s, motion, name, hand, opening_m)
        self._say(self._begin(handle, motion, message))

    def lead(
        self,
        handle: MotionHandle,
        motion: int,
        world_version: int,
        document: str,
        felt: Callable[[YieldReport], None],
    ) -> None:
        """Start a yielding hand; what it feels is told on the way."""
        self._felt[motion] = felt
        message = Lead(self._next(), self.now_s, motion, world_version)
        self._say(self._begin(handle, motion, message), document)

    def jog(
        self,
        handle: MotionHandle,
        motion: int,
        world_version: int,
        document: str,
        told: Callable[[JogReport], None],
    ) -> None:
        """Begin to be jogged; what holds it back is told on the way."""
        self._jogged[motion] = told
        message = BeginJog(self._next(), self.now_s, motion, world_version)
        self._say(self._begin(handle, motion, message), document)

    def walk(self, handle: MotionHandle, motion: int, document: str) -> None:
        """Set out."""
        self._say(self._begin(handle, motion, Walk(self._next(), self.now_s, motion)), document)

    def steer(self, handle: MotionHandle, document: str) -> None:
        """Go somewhere else with a walk, or be jogged on; one that has ended is left alone."""
        for number in self._numbers_of(handle):
            self._say(Steer(self._next(), self.now_s, number), document)

    def finish(self, handle: MotionHandle) -> None:
        """Bring a walk or a yielding hand to its end; one that has ended is left alone."""
        for number in self._numbers_of(handle):
            message = FinishMotion(self._next(), number)
            self._when_refused(message.number, lambda _reason: self.finish(handle))
            self._say(message)

    def cancel(self, handle: MotionHandle, reason: str) -> None:
        """Brake a motion and hold."""
        for number in self._numbers_of(handle):
            message = CancelMotion(self._next(), number, reason[:500])
            self._when_refused(message.number, lambda _reason: self.cancel(handle, reason))
            self._say(message)

    def pause(self, reason: str) -> None:
        """Hold what is under way where it is."""
        message = Pause(self._next(), reason[:500])
        self._when_refused(message.number, lambda _reason: self.pause(reason))
        self._say(message)

    def resume(self) -> None:
        """Go on with it."""
        message = Resume(self._next(), self.now_s)
        self._when_refused(message.number, lambda _reason: self.resume())
        self._say(message)

    def offer(self, person: str) -> None:
        """Tell people that something is held out, and to whom."""
        message = Offer(self._next(), person[:500])
        self._when_refused(message.number, lambda _reason: self.offer(person))
        self._say(message)

    def stop(self, category: int, reason: str) -> None:
        """Engage the emergency stop."""
        self._connection.send(write_control_message(Stop(category, reason[:500])))

    # ---------------------------------------------------------------- inside

    def _next(self) -> int:
        self._number += 1
        return self._number

    def _say(self, message: ControlMessage, document: str = "") -> None:
        payload = write_control_message(message)
        if document:
            self._connection.send(payload + b"\n" + document.encode(), FrameKind.DOCUMENT)
        else:
            self._connection.send(payload)

    def _numbers_of(self, handle: MotionHandle) -> list[int]:
        return [number for number, known in self._motions.items() if known is handle]

    def _begin(self, handle: MotionHandle, motion: int, message: M) -> M:
        """Follow a motion from now on; a command that is refused, or lost, refuses it."""
        self._motions[motion] = handle

        def refused(reason: str) -> None:
            self._follow({"motion": motion, "status": "refused", "progress": 0.0, "reason": reason})

        self._when_refused(message.number, refused)
        return message

    def _when_refused(self, number: int, call: Callable[[str], None]) -> None:
        self._refusals[number] = call
        while len(self._refusals) > _REMEMBERED:
            self._refusals.popitem(last=False)

    def _refused(self, number: int, reason: str) -> None:
        """A command was not obeyed; a refusal of nothing in particular comes before the end."""
        if number == 0:
            self.lost = self.lost or reason
        elif (call := self._refusals.pop(number, None)) is not None:
            call(reason)

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
                self.about, self.emergency = message, emergency_of(message["emergency"])
                self._note_health(message["health"])
            case "health":
                self._note_health(message)
            case "emergency":
                self.emergency = emergency_of(message)
            case "motion":
                self._follow(message)
            case "frame":
                self.frames[str(message.get("source", HEAD))] = read_frame(message)
            case "scan":
                self.scan = read_scan(message)
            case "felt":
                self._feel(message)
            case "jogged" if (told := self._jogged.get(message["motion"])) is not None:
                told(JogReport(str(message["held_back"]), bool(message["moving"])))
            case "event":
                event = event_of(message)
                if event is not None:
                    self._listen(event)
            case "admitted" | "unsafe" | "rejected":
                self._note_verdict(message)
            case "refused":
                self._refused(int(message["number"]), str(message["reason"]))
            case "error":
                self.lost = self.lost or str(message["reason"])
            case _:
                pass

    def _note_health(self, values: Mapping[str, Any]) -> None:
        self.defects = tuple(map(str, values["defects"]))
        self.reservations = tuple(map(str, values["reservations"]))

    def _note_verdict(self, message: Mapping[str, Any]) -> None:
        # judged: nobody refuses the question any more, and its document, a large one, is let go
        self._refusals.pop(self._judged_by.pop(message["trajectory"], 0), None)
        verdict: Verdict = True
        if message["type"] == "unsafe":
            verdict = Unsafe(tuple(map(finding_of, message["findings"])))
        elif message["type"] == "rejected":
            verdict = str(message["reason"])
        self.verdicts[message["trajectory"]] = verdict
        while len(self.verdicts) > _KEPT_VERDICTS:  # of jobs that nobody asks for any more
            del self.verdicts[next(iter(self.verdicts))]

    def _feel(self, message: Mapping[str, Any]) -> None:
        tell = self._felt.get(message["motion"])
        if tell is not None:
            tell(report_of(message))

    def _follow(self, message: Mapping[str, Any]) -> None:
        handle = self._motions.get(message["motion"])
        if handle is None:
            return
        handle.progress = float(message["progress"])
        status = MotionStatus(message["status"])
        if status is not MotionStatus.RUNNING:
            del self._motions[message["motion"]]
            self._felt.pop(message["motion"], None)
            self._jogged.pop(message["motion"], None)
            if not handle.finished:
                handle.reason = str(message["reason"])
                handle.met_something = bool(message.get("met_something", False))
                handle.status = status

    def _lose(self) -> None:
        self.lost = self.lost or "the control process ended the connection"
        for handle in self._motions.values():
            handle.status, handle.reason = MotionStatus.CANCELED, self.lost
        self._motions.clear()
        raise ControlLostError(self.lost)
