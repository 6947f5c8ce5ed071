"""A person's terminal beside a served robot: keys become words on its socket, and nothing else."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, Protocol

from executive.live.caller.caller import Caller, NoAnswerError
from executive.live.desk_messages import HandBack, TakeOver, write_desk_message
from executive.live.jog_message import jog_message
from executive.manual.console import JogConsole
from executive.manual.keys import JogKeys
from executive.manual.words import Ending, JogWord
from executive.screens.jog_screen import JogScreen
from robots.clock import Clock, WallClock
from robots.live.wire.messages import write_message
from robots.live.wire.runtime_folder import RuntimeFolder

_ASK_EVERY_S = 0.2
_KEY_WAIT_S = 0.03


class Keys(Protocol):
    """Where keys come from, by name."""

    def keys(self, timeout_s: float = 0.0) -> tuple[str, ...]:
        """Those that have come."""
        ...


class JogRefusedError(NoAnswerError):
    """The robot is in somebody else's hands."""


class JogDoor:
    """A served robot in a person's hands.

    Args:
        folder: Where the robot is served.

    Attributes:
        held_back: What holds the robot back, as it said last.
        by_hand: Whether the robot is in a person's hands.
        task: What it was told to do, or nothing.
        line: What the robot said last.
        began_it: Whether what goes on was begun here; else whoever gave the task hears its result.
        result: The message with the result of what was begun here, once there is one.
    """

    def __init__(self, folder: Path) -> None:
        """Take over.

        Raises:
            NotServedError: No robot is served there.
            JogRefusedError: Somebody else has it.
        """
        self._caller = Caller(RuntimeFolder(folder).executive_socket)
        self.held_back = self.task = self.line = ""
        self.by_hand = False
        self.result: Mapping[str, Any] | None = None
        self._asked_s = -_ASK_EVERY_S
        answer = self._caller.ask(write_desk_message(TakeOver()))
        if answer["type"] == "refused":
            raise JogRefusedError(str(answer["reason"]))
        self.began_it = not answer.get("under_way", False)
        self._take(answer)

    def say(self, word: JogWord | None, may_touch: bool) -> None:
        """Say a word; None brakes."""
        self._caller.send(write_desk_message(jog_message(word, may_touch)))

    def hand_back(self, ending: Ending) -> None:
        """Give the robot back, and say what is so."""
        self._caller.send(write_desk_message(HandBack(ending)))

    def poll(self, now_s: float) -> None:
        """Hear what the robot says, and ask how things stand a few times a second.

        Raises:
            LiveError: The connection has ended.
        """
        if now_s - self._asked_s >= _ASK_EVERY_S:
            self._asked_s = now_s
            self._caller.send(write_message("status"))
        for message in self._caller.poll():
            self._take(message)

    def close(self) -> None:
        """Hang up; a robot that was not given back comes to rest, and its task is given up."""
        self._caller.close()

    def _take(self, message: Mapping[str, Any]) -> None:
        match message["type"]:
            case "status":
                self.held_back, self.by_hand = str(message["held_back"]), bool(message["by_hand"])
                self.task = str(message["task"] or "")
            case "line":
                self.line = str(message["text"])
            case "result":
                self.result, self.line = message, str(message["text"])
            case "error":
                self.line = str(message["reason"])


def jog(
    door: JogDoor, keys: Keys, jog_keys: JogKeys, show: Callable[[JogScreen], None], wall: Clock
) -> Ending | None:
    """Let a person jog until the robot is given back; gives how, or None where it was taken away.

    Args:
        door: The robot.
        keys: The keyboard.
        jog_keys: What keys mean.
        show: Draws the screen; called when it has changed.
        wall: Wall time.
    """
    console, shown, had_it = JogConsole(jog_keys, door), None, False
    while door.result is None and not (had_it and not door.by_hand):
        had_it = had_it or door.by_hand
        for key in dict.fromkeys(keys.keys(_KEY_WAIT_S)):
            console.press(key, wall.now_s())
        if console.given_back is not None:
            return console.given_back
        door.poll(wall.now_s())
        screen = JogScreen(door.task, console.jogged, door.held_back, door.line, console.ending)
        if screen != shown:
            show(screen)
            shown = screen
    return None


def told_at_the_end(door: JogDoor, wall: WallClock, within_s: float = 600.0) -> tuple[str, int]:
    """What became of it: the result line with its exit code, once the task has ended.

    Args:
        door: Given back.
        wall: Wall time.
        within_s: How long the task may go on; the line of another person's task is theirs to hear.
    """
    until_s = wall.now_s() + within_s
    while door.result is None and door.began_it and wall.now_s() < until_s:
        door.poll(wall.now_s())
        wall.sleep(_KEY_WAIT_S)
    if door.result is None:
        return "the robot was given back; whoever gave the task hears how it ends", 0
    return str(door.result["text"]), int(door.result["exit_code"])
