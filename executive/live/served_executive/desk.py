"""Where people reach a served executive: sentences, cancels and questions about how things stand."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, Protocol, cast, get_args

from executive.dialogue.clarification import OpenQuestion
from executive.exit_codes import ExitCode
from executive.live.desk_messages import (
    _MESSAGES,
    MAX_STATEMENTS,
    Answer,
    Cancel,
    DeskMessage,
    FollowTrajectory,
    GetScene,
    GetTree,
    GetWorld,
    HandBack,
    Jog,
    Listen,
    PauseTask,
    ResumeTask,
    Say,
    Script,
    ScriptLine,
    TakeOver,
    Velocity,
    Watch,
)
from executive.live.served_executive.tree_file import TreeFile
from executive.live.served_executive.watchers import Watchers
from executive.manual.words import BY_HAND, ENDINGS, ByHandTask, Ending
from executive.meaning import Parsed
from executive.trust import Trust
from executive.understanding.conversation import Conversation
from executive.understanding.statement import Expectation, OnFailure, Statement
from executive.understanding.understanding import understand
from robots.live.wire.connection import Connection
from robots.live.wire.errors import ProtocolError
from robots.live.wire.framing import Frame
from robots.live.wire.messages import GetStatus, read_object, strictly, write_message
from robots.live.wire.runtime_folder import RuntimeFolder
from robots.live.wire.socket_server import SocketServer
from trees.tasks import MoveTask

Said = Say | Script | Velocity | FollowTrajectory | TakeOver
"""What is begun as an order; a velocity is one while velocities follow it, and so is a person's jogging."""


def name_of(said: Said) -> str:
    """What an order is called to people."""
    if isinstance(said, Velocity):
        return "velocities"
    if isinstance(said, FollowTrajectory):
        return "follow a trajectory"
    if isinstance(said, TakeOver):
        return BY_HAND
    if isinstance(said, Script) or said.text:
        return said.text
    return f"velocity {said.linear_m_s:g} m/s, {said.angular_rad_s:g} rad/s"


def statements_of(
    said: Say | Script | Velocity | TakeOver, before: Conversation, trust: Trust
) -> Iterator[Statement]:
    """Understand what was said, one statement after the other.

    Args:
        said: The order.
        before: What was said before; remembers what is said now.
        trust: How far a model's output is trusted.
    """
    if isinstance(said, Script):
        for line in said.lines:
            yield _of_script(line, before, trust)
    elif isinstance(said, Velocity):
        text = "follow the velocities that are sent"
        yield Statement(Parsed(text, (MoveTask(text, is_fed=True),)))
    elif isinstance(said, TakeOver):
        yield Statement(Parsed(BY_HAND, (ByHandTask(BY_HAND),)))
    elif said.text:
        understood = before.understand(said.text, trust)
        yield Statement(understood.parsed, timeout_s=said.timeout_s or None).meaning(understood)
    else:
        text = f"move at {said.linear_m_s:g} m/s and {said.angular_rad_s:g} rad/s"
        yield Statement(Parsed(text, (MoveTask(text, said.linear_m_s, said.angular_rad_s),)))


def _of_script(line: ScriptLine, before: Conversation, trust: Trust) -> Statement:
    """A statement as ``load_script`` makes it; the desk has judged the words for failure and expectation."""
    asks = line.expect == "question"
    understood = understand(line.text, trust) if asks else before.understand(line.text, trust)
    return Statement(
        understood.parsed,
        cast(OnFailure, line.on_failure),
        cast(Expectation, line.expect),
        line.timeout_s or None,
    ).meaning(understood)


MAX_WAITING = 1
"""Sentences that wait; a second one at the same time is refused."""


class Attended(Protocol):
    """Who carries out what the desk takes in."""

    def cancel(self, reason: str) -> None:
        """Halt what is under way, and hold."""
        ...

    def pause(self, reason: str) -> None:
        """Hold what is under way where it is."""
        ...

    def resume(self) -> None:
        """Go on with it."""
        ...

    def status(self) -> Mapping[str, Any]:
        """How things stand, as JSON values."""
        ...

    def scene(self) -> Sequence[Mapping[str, Any]]:
        """What the robot believes to be around it, as JSON values."""
        ...

    def world(self) -> Mapping[str, Any]:
        """What is believed of the world, solids with their poses and errors, as JSON values."""
        ...

    def take_over(self) -> None:
        """Let a person have the task that is under way."""
        ...

    def hear_jog(self, message: Jog) -> None:
        """Take a word of the person who has the robot.

        Raises:
            ProtocolError: It is none of this robot's.
        """
        ...

    def hand_back(self, ending: Ending) -> None:
        """Take the robot back from the person."""
        ...

    def hear_velocity(self, linear_m_s: float, angular_rad_s: float) -> None:
        """Take the newest of the velocities that are sent while the robot walks at them."""
        ...


class Order:
    """A sentence, a script or velocities that somebody wants carried out, and the way back to them.

    Args:
        said: What is wanted.
        connection: Whose it is.
        listeners: Who else hears what becomes of it.
    """

    def __init__(self, said: Said, connection: Connection, listeners: Sequence[Connection] = ()) -> None:
        self.said = said
        self.connection = connection
        self._listeners = listeners

    def tell(self, line: str) -> None:
        """Send a line of feedback."""
        self.connection.send(write_message("line", text=line))
        self._let_hear(line)

    def ask(self, question: OpenQuestion) -> None:
        """Send a question, in lines for people and as a message for programs."""
        for line in (*question.lines(), 'answer with: executive answer "..."'):
            self.tell(line)
        self.connection.send(write_message("question", **question_json(question)))

    def end(self, line: str, outcome: str, code: ExitCode, run: str = "") -> None:
        """Send the result; ``run`` is the folder where it is recorded, if it is."""
        self.connection.send(
            write_message("result", text=line, outcome=outcome, exit_code=int(code), run=run)
        )
        self._let_hear(line)

    def _let_hear(self, line: str) -> None:
        for one in self._listeners:
            if one is not self.connection:
                one.send(write_message("heard", text=line, by=self.connection.peer.pid))


def question_json(question: OpenQuestion) -> dict[str, Any]:
    """A question as JSON values."""
    return {"text": question.text, "choices": list(question.choices), "tried": question.tried}


class Desk:
    """Where a served executive takes in orders, answers, cancels and pauses, by its socket.

    Args:
        path: Where to listen.
        attended: Halts, holds and goes on with what is under way, and says how things stand.
        is_stop: Whether a sentence is the spoken stop, which cancels what is under way.

    Attributes:
        current: The order that is being carried out.
        question: What is asked and not answered yet, or None.
        given: Answers that have come, the oldest first.
        watchers: Who hears of events and trees.
        trees: Writes the tree under way down.
    """

    def __init__(
        self,
        path: Path,
        attended: Attended,
        is_stop: Callable[[str], bool],
    ) -> None:
        self._attended, self._is_stop = attended, is_stop
        self._server = SocketServer(path, self._take, self._ended)
        self._waiting: deque[Order] = deque()
        self._begun: dict[Connection, list[ScriptLine]] = {}
        self._person: Connection | None = None
        self._listeners: list[Connection] = []
        self.watchers, self.trees = Watchers(), TreeFile(RuntimeFolder(path.parent).tree_document)
        self.current: Order | None = None
        self.question: OpenQuestion | None = None
        self.given: list[str] = []

    def poll(self) -> None:
        """Take in what has arrived."""
        self._server.poll()

    def next_order(self) -> Order | None:
        """The next sentence; it is the current one until ``finish``."""
        self.current = self._waiting.popleft() if self._waiting else None
        return self.current

    def finish(self) -> None:
        """The current sentence has ended."""
        self.current = None

    def close(self) -> None:
        """Stop listening; who waits for a turn is told that it does not come."""
        while self._waiting:
            self._waiting.popleft().end("failed: the executive has ended", "failed", ExitCode.FAILED)
        self._server.close()

    def _take(self, connection: Connection, frame: Frame) -> None:
        message: DeskMessage = strictly(_MESSAGES, read_object(frame.payload))
        match message:
            case GetStatus():
                listeners = len(self._listeners)
                connection.send(write_message("status", **self._attended.status(), listeners=listeners))
            case GetScene():
                connection.send(write_message("scene", things=list(self._attended.scene())))
            case GetWorld():
                connection.send(write_message("world", **self._attended.world()))
            case GetTree():
                connection.send(write_message("tree_document", **self.trees.written()))
            case Watch():
                self.watchers.add(connection)
                connection.send(write_message("done"))
            case Listen():
                if connection not in self._listeners:
                    self._listeners.append(connection)
                connection.send(write_message("done", listeners=len(self._listeners)))
            case Cancel(reason):
                under_way = self._halt(reason or "cancelled")
                connection.send(write_message("done", under_way=under_way))
            case PauseTask(reason):
                under_way = self.current is not None
                if under_way:
                    self._attended.pause(reason or "paused")
                connection.send(write_message("done", under_way=under_way))
            case ResumeTask():
                paused = bool(self._attended.status()["paused"])
                self._attended.resume()
                connection.send(write_message("done", paused=paused))
            case Answer(text):
                asked = self.question is not None
                if asked:
                    self.given.append(text)
                connection.send(write_message("done", asked=asked))
            case Velocity(linear_m_s, angular_rad_s):
                if self._begins_or_feeds(message, connection):
                    self._attended.hear_velocity(linear_m_s, angular_rad_s)
            case TakeOver():
                self._take_over(message, connection)
            case Jog():
                if connection is self._person:
                    self._attended.hear_jog(message)
            case HandBack(ending):
                self._hand_back(ending, connection)
            case Say() | FollowTrajectory():
                self._queue(Order(message, connection, self._listeners))
            case ScriptLine():
                self._collect(message, connection)

    def _begins_or_feeds(self, message: Velocity, connection: Connection) -> bool:
        """Whether a velocity is taken: it begins an order, or belongs to the one that its sender began."""
        orders = [*self._waiting, *([self.current] if self.current is not None else [])]
        if any(isinstance(one.said, Velocity) and one.connection is connection for one in orders):
            return True
        if not orders:
            self._queue(Order(message, connection, self._listeners))
            return True
        connection.send(write_message("refused", reason="the robot is busy with something else"))
        return False

    def _take_over(self, message: TakeOver, connection: Connection) -> None:
        """Give what is under way into a person's hands, or begin with nothing else."""
        if self._person is not None and self._person is not connection:
            connection.send(write_message("refused", reason="somebody else jogs the robot"))
            return
        self._person = connection
        under_way = self.current is not None
        if under_way:
            self._attended.take_over()
        else:
            self._queue(Order(message, connection, self._listeners))
        connection.send(write_message("done", under_way=under_way))

    def _hand_back(self, ending: str, connection: Connection) -> None:
        known = next((one for one in ENDINGS if one == ending), None)
        if known is None:
            raise ProtocolError(f"hand_back: no {ending[:20]!r}; there are {', '.join(ENDINGS)}")
        if connection is self._person:
            self._person = None
            self._attended.hand_back(known)

    def _collect(self, line: ScriptLine, connection: Connection) -> None:
        """Take one more statement of a script, and queue the script with its last one."""
        for value, known in ((line.on_failure, OnFailure), (line.expect, Expectation)):
            if value not in get_args(known):
                raise ProtocolError(f"statement: no {value[:40]!r}; there are {', '.join(get_args(known))}")
        lines = self._begun.setdefault(connection, [])
        if len(lines) >= MAX_STATEMENTS:
            raise ProtocolError(f"a script has {MAX_STATEMENTS} statements at most")
        lines.append(line)
        if line.last:
            self._queue(Order(Script(tuple(self._begun.pop(connection))), connection, self._listeners))

    def _queue(self, order: Order) -> None:
        if self._says_stop(order.said) and self._halt("stop was said"):
            order.end("done: what was under way is halted", "done", ExitCode.DONE)
        elif self.current is not None or len(self._waiting) >= MAX_WAITING:
            under_way = self.current or self._waiting[0]
            busy = f"{name_of(under_way.said)!r} (of process {under_way.connection.peer.pid})"
            order.end(
                f"refused: the robot is busy with {busy}; `executive cancel` halts what is under way",
                "refused",
                ExitCode.INVALID,
            )
        else:
            self._waiting.append(order)

    def _halt(self, reason: str) -> bool:
        """Cancel what is under way, and what has come and not begun yet; whether there was anything."""
        waited = list(self._waiting)
        self._waiting.clear()
        for order in waited:
            order.end(f"cancelled: {reason}", "cancelled", ExitCode.CANCELLED)
        if self.current is not None:
            self._attended.cancel(reason)
        return bool(waited) or self.current is not None

    def _says_stop(self, said: Said) -> bool:
        if isinstance(said, Velocity | FollowTrajectory | TakeOver):
            return False
        texts = [line.text for line in said.lines] if isinstance(said, Script) else [said.text]
        return all(self._is_stop(text) for text in texts)

    def _ended(self, connection: Connection) -> None:
        self._begun.pop(connection, None)
        if connection in self._listeners:
            self._listeners.remove(connection)
        self.watchers.remove(connection)
        if connection is self._person:
            self._person = None
            self._attended.hand_back("give_up")
        self._waiting = deque(order for order in self._waiting if order.connection is not connection)
        if self.current is not None and self.current.connection is connection:
            self._attended.cancel("who gave the task has gone")
