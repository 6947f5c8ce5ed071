"""A served robot with its processes, watched from outside: for the suites of live mode."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from executive.live.caller.caller import Caller
from executive.live.caller.service import Service, ServiceRequest
from executive.live.desk_messages import Say, write_desk_message
from robots.clock import WallClock
from robots.live.wire.errors import LiveError, NotServedError
from robots.live.wire.messages import GetStatus, Hello, Shutdown, write_control_message, write_message
from robots.live.wire.state_slot import StateSlotReader
from tools.evaluate.scenes import SENTENCE, episode_scene, workspace_of

OPEN_FLOOR = "robot_start = { x_m = 0.0, y_m = 0.0, yaw_rad = 0.0 }\n"
"""A scene with nothing in it."""
OVERLOADED = "control periods late"
"""In the refusal of a task that a machine is too busy for."""
_MOTIONS = 7
"""Motions of a pick: looks, openings, reach, approach, closing, lift."""
_TASK_WALL_S = 400.0
_LOOK_S = 0.001
_TRIES = 20


class ServedRobot:
    """A robot in the random scene of a seed, served from a folder.

    Attributes:
        service: The processes.
        runs: Where its runs are recorded.
        events: The control layer's events so far.
        now_s: Control time at the last look.
        resting: Whether the body rested then.
    """

    def __init__(
        self,
        folder: Path,
        seed: int,
        robot: str,
        pace: float,
        *,
        realtime: bool = True,
        fault: str = "",
        scene: str | None = None,
    ) -> None:
        """Serve it, and begin to observe; real-time scheduling is used where it is permitted.

        Args:
            folder: For the scene, the sockets and the runs.
            seed: Of scene and run.
            robot: Its name.
            pace: Control time that passes in a second.
            realtime: Whether to ask for real-time scheduling.
            fault: Of the connection, see ``robots.live.wire.faulty_connection``.
            scene: The text of a scene's file; None for the random one of a pick.

        Raises:
            LiveError: It cannot be served.
        """
        file = folder / "scene.toml"
        file.write_text(episode_scene(seed, None, workspace_of(robot)) if scene is None else scene, "utf-8")
        self._wall = WallClock()
        self.pace, self.runs = pace, folder / "runs"
        request = ServiceRequest(
            folder / "live",
            robot,
            os.fspath(file),
            seed,
            self.runs,
            pace,
            realtime,
            evaluation=True,
            fault=fault,
        )
        self.service = Service(request, lambda _line: None)
        self._folder = self.service.folder
        self._observer = Caller(self._folder.control_socket)
        self._observer.ask(write_control_message(Hello("observer")))
        self._slot = StateSlotReader(self._folder.state_slot)
        self._ended: list[dict[str, Any]] = []
        self.events: list[dict[str, Any]] = []
        self.now_s, self.resting = 0.0, True

    def look(self) -> float:
        """Take in what has been told; returns control time."""
        self.events += self._observer.arrived("event")
        row = self._slot.newest()
        if row is not None:
            self.now_s, self.resting = float(row[0]), bool(row[1])
        return self.now_s

    def wait(self, condition: Callable[[], bool], what: str) -> None:
        """Wait until something is so.

        Raises:
            LiveError: It did not come about.
        """
        until_s = self._wall.now_s() + _TASK_WALL_S
        while not condition():
            if self.service.control.poll() is not None:
                raise LiveError("the control process ended")
            if self._wall.now_s() > until_s:
                raise LiveError(f"in vain: {what}")
            self._wall.sleep(_LOOK_S)

    def wait_until_ready(self) -> None:
        """Wait for the executive, and for a machine that keeps up."""
        self.wait(self.commanded, "an executive attaches")
        self.wait(self.keeps_up, "the control process keeps up")

    def wait_for_instant(self, rng: np.random.Generator) -> str:
        """Wait for a random instant of a random motion; names it, or nothing when the task has ended."""
        wanted = int(rng.integers(1, _MOTIONS + 1))
        offset_s = float(rng.uniform(0.05, 1.2))
        self.wait(lambda: self.started >= wanted or self._idle(), "the motion begins")
        began_s = self.look()
        self.wait(lambda: self.look() > began_s + offset_s, "the instant comes")
        running = self.status()["motions"]
        return str(running[0]) if running else ""

    def stand(self, seconds: float) -> bool:
        """Let control time pass as fast as it goes; tells whether the robot has fallen."""
        self.evaluate(write_message("pace", pace=0.0))
        until_s = self.look() + seconds
        self.wait(lambda: self.look() > until_s, "it stands for a while")
        fallen = self.fallen()
        self.evaluate(write_message("pace", pace=self.pace))
        return fallen

    def fallen(self) -> bool:
        """Whether the robot lies on the floor, by the simulator's truth."""
        return bool(self.evaluate(write_message("truth"))["fallen"])

    def keeps_up(self) -> bool:
        """Whether nothing stands against a new task."""
        self._wall.sleep(0.1)
        return not self.status()["reservations"]

    def commanded(self) -> bool:
        """Whether the executive that was started last commands the robot."""
        self._wall.sleep(0.1)
        pid = self.service.executive.pid
        return self._listener() == pid and bool(self.status()["commander"] == pid)

    def _listener(self) -> int | None:
        """The process that takes sentences; for a moment it may be another one than commands the robot."""
        try:
            caller = Caller(self._folder.executive_socket)
        except NotServedError:
            return None
        try:
            return caller.peer_pid
        finally:
            caller.close()

    def status(self) -> dict[str, Any]:
        """The control process's."""
        return self._ask(self._folder.control_socket, write_control_message(GetStatus()))

    def evaluate(self, message: bytes) -> dict[str, Any]:
        """Ask for the simulator's truth, or set its pace."""
        return self._ask(self._folder.evaluation_socket, message)

    def send(self, sentence: str = SENTENCE) -> Caller:
        """Say a sentence; the connection's end would cancel the task."""
        self._task = Caller(self._folder.executive_socket)
        self._task.send(write_desk_message(Say(sentence)))
        return self._task

    def results(self) -> list[dict[str, Any]]:
        """Results of the sentence that have come; empty once its executive has gone."""
        self._ended += self._task.arrived("result")
        return self._ended

    def carry_out(self, sentence: str) -> tuple[int, str]:
        """Say a sentence and wait for its result: exit code and line."""
        result: dict[str, Any] = {}

        def take(answer: dict[str, Any]) -> bool:
            if answer["type"] in ("result", "error"):
                result.update(answer)
            return bool(result)

        for _ in range(_TRIES):
            result.clear()
            self.send(sentence).listen(take, _TASK_WALL_S)
            if OVERLOADED not in str(result.get("text")):
                break
            self.wait(self.keeps_up, "the control process keeps up")
        return int(result.get("exit_code", 70)), str(result.get("text", result))

    def end(self) -> None:
        """Shut it down."""
        try:
            self._ask(self._folder.control_socket, write_control_message(Shutdown()))
            self.service.control.wait(20.0)
        except (LiveError, subprocess.TimeoutExpired):
            self.service.control.kill()
            self.service.control.wait()
        self.service.close()

    def _ask(self, path: Path, message: bytes) -> dict[str, Any]:
        caller = Caller(path)
        try:
            return caller.ask(message, within_s=20.0)
        finally:
            caller.close()

    @property
    def started(self) -> int:
        """Motions that have begun so far."""
        self.look()
        return sum(event["event"] == "MotionStarted" for event in self.events)

    def _idle(self) -> bool:
        """Whether the task was done before the motion that was waited for.

        Raises:
            LiveError: It was not done.
        """
        self.results()
        if self._ended and OVERLOADED in self._ended[0]["text"]:  # the machine, not the robot: say it again
            self._ended.clear()
            self.wait(self.keeps_up, "the control process keeps up")
            self.send()
        if self._ended and self._ended[0]["exit_code"] != 0:
            raise LiveError(f"the task did not come so far: {self._ended[0]['text']}")
        return bool(self._ended)
