"""``python -m tools.pictures.record_chat``: what the chat's screen showed in a real conversation, for
`tools.pictures.draw_chat`.

Somebody asks for "the cup" where there are two, answers, says something in between, and stops the robot in
the middle of a motion.
"""

from __future__ import annotations

import io
import json
import tempfile
from collections.abc import Callable
from dataclasses import asdict
from pathlib import Path

from rich.console import Console

from executive.chat.chat_screen import ChatView
from executive.chat.robot_watch import RobotWatch
from executive.chat.screen_chat import ScreenChat
from executive.chat.talk import Talk
from executive.doors.own_robot import OwnRobot
from executive.screens.rows import running_step
from robots.clock import WallClock

RECORDED = Path(__file__).with_name("chat.json")
_HOW_TO_RESET = "Nothing moves until you type 'reset' here, once it is safe."
_PATIENCE = 6000
_LOOK_EVERY_S = 0.02


class _Typist:
    """Types what it is told to."""

    def __init__(self) -> None:
        self.next = b""

    def typed(self, _timeout_s: float) -> bytes | None:
        """What is typed now."""
        typed, self.next = self.next, b""
        return typed


def _conversation() -> dict[str, ChatView]:
    views: dict[str, ChatView] = {}
    wall, typist = WallClock(), _Typist()
    with (
        tempfile.TemporaryDirectory() as folder,
        OwnRobot(["--scene=clutter", "--seed=7", f"--record={folder}"], print) as own,
    ):
        robot = own.wait(lambda: False)
        watch = RobotWatch(robot)
        shown = ScreenChat(Console(file=io.StringIO()), typist, "talos in clutter", lambda: watch.now)
        talk = Talk(robot, shown.show, shown.log, lambda: watch.now, _HOW_TO_RESET)

        def until(condition: Callable[[], bool]) -> None:
            for _ in range(_PATIENCE):
                shown.take_keys(talk, 0.0)
                talk.poll()
                if condition():
                    return
                wall.sleep(_LOOK_EVERY_S)
            raise TimeoutError(shown.said)

        def type_in(text: str) -> None:
            typist.next = text.encode()
            until(lambda: not typist.next)

        type_in("what's on the table\r")
        until(lambda: not talk.under_way)
        type_in("pick up the cup\r")
        until(lambda: talk.question is not None)
        type_in("the re")
        wall.sleep(0.3)
        views["asking"] = shown.view(talk)
        type_in("d one\r")
        until(lambda: "stream reach" in running_step(watch.now.tree))
        type_in("then wave\r")
        type_in("\x15what are you doing?\r")
        type_in("and put it ba")
        wall.sleep(0.3)
        views["working"] = shown.view(talk)
        type_in("\x15stop\r")
        until(lambda: not talk.under_way)
        wall.sleep(0.5)
        type_in("why\r")
        views["stopped"] = shown.view(talk)
        watch.close()
    return views


def main() -> None:
    """Talk, and write what was shown."""
    text = json.dumps({name: asdict(view) for name, view in _conversation().items()})
    RECORDED.write_text(text + "\n", "utf-8")


if __name__ == "__main__":
    main()
