"""What the control process does with what it is told: one commander, any number of observers.

Nothing that arrives here is trusted. A command is taken from the commander alone, in its order and while it
is fresh; a trajectory is streamed only after this side's own checker let it pass; a stop is taken from
anybody at any time.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

from kinematics.motion.verdict import CheckedTrajectory
from robots.clock import Clock
from robots.control.events import ControlEvent
from robots.control.loop.control_loop import ControlLoop
from robots.control.loop.emergency_stop import PersonsReset
from robots.control.loop.watchdog import Watchdog
from robots.control.motion_handle import MotionStatus
from robots.live.documents.camera_message import cameras_json
from robots.live.process.admission import AdmissionDesk, Asks, Verdict, verdict_message
from robots.live.process.bulletin import Bulletin, Wanted
from robots.live.process.condition import condition_json, emergency_json, health_json, moves
from robots.live.process.motion_desk import MotionDesk, motion_message
from robots.live.wire.connection import Connection
from robots.live.wire.errors import ProtocolError
from robots.live.wire.framing import VERSION, Frame, FrameKind
from robots.live.wire.message_order import MAX_AGE_S, MessageOrder
from robots.live.wire.messages import (
    Admit,
    BeginJog,
    CancelMotion,
    ControlMessage,
    FinishMotion,
    GetStatus,
    Guarded,
    Headed,
    Heartbeat,
    Hello,
    Lead,
    Offer,
    Pause,
    Reset,
    Resume,
    Shutdown,
    Start,
    Steer,
    Stop,
    Walk,
    read_control_message,
    write_message,
)
from robots.live.wire.socket_server import KEPT, SocketServer
from robots.perception.detector import Detector, RangeSensor
from robots.perception.fusion.cameras import PlacedCamera

IDLE_SILENCE_S = 3.0
"""A commander that is silent for so long while nothing is under way loses its place; nothing needs a stop."""


class ControlServer:
    """The socket's side of the control process; ``poll`` once a control period, before it is decided.

    Attributes:
        ending: Whether somebody asked for the end.
    """

    def __init__(
        self,
        path: Path,
        loop: ControlLoop,
        clock: Clock,
        detector: Detector,
        checker: Asks,
        about: Mapping[str, Any],
        health: Callable[[], Mapping[str, Any]] = dict,
        ranging: RangeSensor | None = None,
        on_offer: Callable[[str], None] = lambda _person: None,
        cameras: Sequence[PlacedCamera] = (),
    ) -> None:
        """Listen.

        Args:
            path: Of the socket.
            loop: The control loop.
            clock: Control time.
            detector: Frames for the commander.
            checker: The admission process.
            about: What everyone who connects is told: robot, scene, seed, period.
            health: Further facts for the status.
            ranging: Range scans for the commander.
            on_offer: Called when the robot begins to hold something out, with whom it is for.
            cameras: Those that stand in the room: further frames for the commander.
        """
        self._loop, self._clock = loop, clock
        self._about = {**about, "cameras": cameras_json(cameras)}
        self._health, self._on_offer = health, on_offer
        self._server = SocketServer(path, self._take, self._ended, self._rank)
        self._admission = AdmissionDesk(checker, self._tell_verdict)
        self._watchdog = Watchdog(clock)
        self._commander: Connection | None = None
        self._listeners: list[Connection] = []
        self._motions = MotionDesk(loop)
        self._bulletin = Bulletin(loop, clock, detector, ranging, self._motions, cameras)
        self._order = MessageOrder(clock, self._tell_lost)
        self._world_version = 0
        self._busy = self._looking = self._scanning = False
        self._heard_s = clock.now_s()
        self.ending = False

    def note(self, event: ControlEvent) -> None:
        """Take an event of the control loop, to be told with the next poll."""
        self._bulletin.note(event)

    @property
    def under_way(self) -> bool:
        """Whether anything moves, or the commander is carrying something out."""
        return self._busy or moves(self._loop) or bool(self._motions.running)

    def poll(self) -> None:
        """Read, obey, watch, tell."""
        self._server.poll()
        self._admission.poll()
        silence_s = self._watchdog.silence_s(self._commander is not None and self.under_way)
        if silence_s is not None and self._commander is not None:
            reason = f"no heartbeat for {silence_s:.1f} s"
            self._loop.stop(1, reason)
            self._let_go(reason)
        elif self._commander is not None and self._clock.now_s() - self._heard_s > IDLE_SILENCE_S:
            self._let_go(f"no heartbeat for {IDLE_SILENCE_S:g} s")
        wanted = Wanted(pictures=self._looking, scans=self._scanning)
        self._bulletin.tell(self._commander, self._listeners, wanted)

    def silent_commander(self) -> tuple[int | None, float]:
        """Process of the commander and the control time since it spoke; None when nobody has to speak."""
        if self._commander is None or not self.under_way or self.ending or self._loop.emergency is not None:
            return None, 0.0
        return self._commander.peer.pid, self._clock.now_s() - self._heard_s

    def close(self) -> None:
        """Stop listening; everyone is told why."""
        self._server.broadcast(write_message("error", reason="the robot was shut down"))
        self._server.close()

    # ---------------------------------------------------------------- connections

    def _ended(self, connection: Connection) -> None:
        if connection in self._listeners:
            self._listeners.remove(connection)
        if connection is not self._commander:
            return
        if moves(self._loop) or self._loop.paused:
            self._loop.stop(1, "the connection to the executive ended")
        else:
            self._motions.cancel_all("the connection to the executive ended")
        self._commander = None
        self._busy = self._looking = self._scanning = False
        self._motions.forget()
        self._admission.forget()

    def _rank(self, connection: Connection) -> int:
        """Strangers make room first, then observers; the commander never."""
        return KEPT if connection is self._commander else int(connection in self._listeners)

    def _let_go(self, reason: str) -> None:
        """Give the place of a commander who is silent to another one."""
        if self._commander is not None:
            self._commander.send(write_message("error", reason=reason))
            self._commander.close(reason)

    def _hear_of_it(self) -> None:
        self._watchdog.feed()
        self._heard_s = self._clock.now_s()

    def _take(self, connection: Connection, frame: Frame) -> None:
        if frame.kind is FrameKind.DOCUMENT:
            head, _, document = frame.payload.partition(b"\n")
            self._take_document(connection, read_control_message(head), document)
            return
        self._obey(connection, read_control_message(frame.payload))

    def _take_document(self, connection: Connection, message: ControlMessage, document: bytes) -> None:
        if not isinstance(message, Headed):
            raise ProtocolError("a message of this type has no document")
        if not self._may_command(connection, message.number, message.stamp_s):
            return
        if isinstance(message, Admit | Lead | BeginJog):
            self._world_version = max(self._world_version, message.world_version)
        wrong: str | None
        match message:
            case Admit(_, _, trajectory, version):
                wrong = self._admission.submit(trajectory, version, document)
                if wrong is not None:
                    self._tell_verdict(Verdict(trajectory, wrong))
                return
            case Steer(_, _, motion):
                if (wrong := self._motions.steer(motion, document)) is not None:
                    connection.send(_refused(message.number, wrong))
                return
            case Lead(_, _, motion, version) | BeginJog(_, _, motion, version) if (
                version < self._world_version
            ):
                wrong = f"stale: made for version {version} of the scene, at {self._world_version} now"
            case Lead(_, _, motion, _):
                wrong = self._why_not(motion) or self._motions.lead(motion, document)
            case BeginJog(_, _, motion, _):
                wrong = self._why_not(motion) or self._motions.jog(motion, document)
            case Walk(_, _, motion):
                wrong = self._why_not(motion) or self._motions.walk(motion, document)
        if wrong is not None:
            connection.send(motion_message(motion, MotionStatus.REFUSED, 0.0, wrong))

    def _obey(self, connection: Connection, message: ControlMessage) -> None:
        match message:
            case Stop(category, reason):
                self._loop.emergency_stop(reason or "no reason was given", category)
                connection.send(write_message("done"))
            case Reset(person):
                wrong = self._loop.reset(PersonsReset(person or "somebody"))
                connection.send(write_message("done") if wrong is None else _refused(0, wrong))
            case GetStatus():
                connection.send(write_message("status", **self.status()))
            case Shutdown():
                self.ending = True
                connection.send(write_message("done"))
            case Hello(role):
                self._greet(connection, role)
            case Heartbeat():
                self._hear(connection, message)
            case CancelMotion(number, motion, reason):
                self._require_commander(connection)
                if self._in_order(connection, number):
                    self._motions.cancel(motion, reason)
            case FinishMotion(number, motion):
                self._require_commander(connection)
                if self._in_order(connection, number):
                    self._motions.finish(motion)
            case Pause(number, reason):
                self._require_commander(connection)
                if self._in_order(connection, number):
                    self._loop.pause(reason)
            case Resume(number, stamp_s):
                if self._may_command(connection, number, stamp_s):
                    self._loop.resume()
            case Offer(number, person):
                self._require_commander(connection)
                if self._in_order(connection, number):
                    self._on_offer(person)
            case Start() | Guarded():
                self._start(connection, message)
            case Admit() | Lead() | BeginJog() | Walk() | Steer():
                raise ProtocolError("a message of this type comes with a document")

    def _greet(self, connection: Connection, role: str) -> None:
        if connection in self._listeners:
            raise ProtocolError("hello was said already")
        if role == "commander":
            if self._commander is not None:
                pid = self._commander.peer.pid
                connection.send(_refused(0, f"process {pid} commands the robot already"))
                connection.close("there is a commander")
                return
            self._commander = connection
            self._order.begin()
            self._world_version = 0
            self._hear_of_it()
            connection.allow_documents()
        self._listeners.append(connection)
        welcome = {**self._about, "protocol": VERSION, "t_s": self._clock.now_s()}
        condition = {"emergency": emergency_json(self._loop), "health": health_json(self._loop)}
        connection.send(write_message("welcome", role=role, **condition, **welcome))

    def _hear(self, connection: Connection, message: Heartbeat) -> None:
        self._require_commander(connection)
        if not self._order.is_next(message.number) or not self._order.is_fresh(message.stamp_s):
            return  # one that comes late or twice is no sign of life
        self._hear_of_it()
        self._busy, self._looking, self._scanning = message.busy, message.looking, message.ranging
        self._world_version = max(self._world_version, message.world_version)

    def _require_commander(self, connection: Connection) -> None:
        if connection is not self._commander:
            raise ProtocolError("only the commander may say that")

    def _in_order(self, connection: Connection, number: int) -> bool:
        before = self._order.number
        if not self._order.is_next(number):
            # the one that came before it may have been obeyed: this says nothing of that one
            told = {"number": number, "reason": f"number {number} after {before}"}
            connection.send(write_message("ignored", **told))
            return False
        self._hear_of_it()
        return True

    def _may_command(self, connection: Connection, number: int, stamp_s: float) -> bool:
        self._require_commander(connection)
        if not self._in_order(connection, number):
            return False
        if not self._order.is_fresh(stamp_s):
            age_s = self._order.age_s(stamp_s)
            connection.send(_refused(number, f"stale: {age_s:.2f} s old, at most {MAX_AGE_S} s"))
            return False
        return True

    # ---------------------------------------------------------------- motions

    def _start(self, connection: Connection, message: Start | Guarded) -> None:
        if not self._may_command(connection, message.number, message.stamp_s):
            return
        wrong = self._why_not(message.motion)
        if wrong is None and isinstance(message, Start):
            checked = self._admission.take(message.trajectory, self._world_version)
            if isinstance(checked, CheckedTrajectory):
                self._motions.stream(message.motion, checked)
                return
            wrong = checked
        elif wrong is None and isinstance(message, Guarded):
            wrong = self._motions.guard(message.motion, message.name, message.hand, message.opening_m)
        if wrong is not None:
            connection.send(motion_message(message.motion, MotionStatus.REFUSED, 0.0, wrong))

    def _why_not(self, motion: int) -> str | None:
        return "the robot is being shut down" if self.ending else self._motions.why_not(motion)

    # ---------------------------------------------------------------- telling

    def status(self) -> dict[str, Any]:
        """How things stand, as JSON values."""
        return {
            **self._about,
            "t_s": round(self._clock.now_s(), 3),
            **condition_json(self._loop),
            "under_way": self.under_way,
            "motions": [handle.name for handle in self._motions.running],
            "commander": None if self._commander is None else self._commander.peer.pid,
            **self._health(),
        }

    def _tell_lost(self, number: int) -> None:
        if self._commander is not None:
            self._commander.send(_refused(number, "it was lost on its way"))

    def _tell_verdict(self, verdict: Verdict) -> None:
        if self._commander is not None:
            self._commander.send(verdict_message(verdict))


def _refused(number: int, reason: str) -> bytes:
    return write_message("refused", number=number, reason=reason)
