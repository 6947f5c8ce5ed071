"""One episode of suite ``kill``: a served robot whose executive is killed, or hangs, during a task."""

from __future__ import annotations

import os
import signal
import subprocess
import tempfile
import traceback
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from executive.live.caller import Caller
from executive.live.desk import Say, write_desk_message
from executive.live.service import Service, ServiceRequest
from robots.clock import WallClock
from robots.live.errors import LiveError
from robots.live.messages import GetStatus, Hello, Shutdown, write_control_message, write_message
from robots.live.state_slot import StateSlotReader
from tools.evaluate.scenes import SENTENCE, pick_scene

KILL_WITHIN_S = 0.1
HANG_WITHIN_S = 1.1
"""Control time in which braking must begin; two control periods more for what is on its way."""
ON_ITS_WAY_S = 0.004
STANDS_S = 30.0
AFTERWARDS = "go home"
_MOTIONS = 7
"""Motions of a pick: looks, openings, reach, approach, closing, lift."""
_TASK_WALL_S = 400.0
_LOOK_S = 0.001
_TRIES = 20
_OVERLOADED = "control periods late"
"""In the refusal of a task that a machine is too busy for."""


@dataclass(frozen=True, slots=True)
class KillRecord:
    """How an episode ended.

    Attributes:
        seed: Of scene, run and instant.
        signal: "SIGKILL" or "SIGSTOP".
        outcome: "stood", "fell", "not stopped", "not resumed" or "error".
        motion: Name of the motion that was under way; empty when nothing moved.
        braking_s: Control time from the signal to the beginning of the stop; None when nothing moved.
        rest_s: Control time from the signal to rest.
        refused: Setpoints that the gate refused.
        fallen: Whether the robot fell.
        resumed: Whether a new executive attached and completed a task.
        t_s: Control time of the signal.
        late_p99_ms, lost_s: Of the control process, for the record.
        detail: What went wrong.
    """

    seed: int
    signal: str
    outcome: str
    motion: str = ""
    braking_s: float | None = None
    rest_s: float | None = None
    refused: int = 0
    fallen: bool = False
    resumed: bool = False
    t_s: float = 0.0
    late_p99_ms: float = 0.0
    lost_s: float = 0.0
    detail: str = ""

    @property
    def in_time(self) -> bool:
        """Whether braking began in time, or nothing had to be braked."""
        bound_s = KILL_WITHIN_S if self.signal == "SIGKILL" else HANG_WITHIN_S
        return not self.motion or (self.braking_s is not None and self.braking_s <= bound_s + ON_ITS_WAY_S)

    @property
    def good(self) -> bool:
        """Whether everything was as it has to be."""
        return self.outcome == "stood"


def run_kill_episode(seed: int, robot: str, hang: bool, pace: float) -> KillRecord:
    """Run one episode at a pace of control time; whatever breaks becomes its record."""
    name = "SIGSTOP" if hang else "SIGKILL"
    with tempfile.TemporaryDirectory(prefix="kill-") as folder:
        try:
            return _Episode(Path(folder), seed, robot, hang, pace).run()
        except Exception:
            return KillRecord(seed, name, "error", detail=traceback.format_exc())


class _Episode:
    def __init__(self, folder: Path, seed: int, robot: str, hang: bool, pace: float) -> None:
        self._seed, self._hang, self._pace = seed, hang, pace
        self._rng = np.random.default_rng([seed, hang])
        scene = folder / "scene.toml"
        scene.write_text(pick_scene(seed, None), "utf-8")
        self._wall = WallClock()
        live = folder / "live"
        request = ServiceRequest(live, robot, os.fspath(scene), seed, folder / "runs", pace, evaluation=True)
        self._service = Service(request, lambda _line: None)
        self._folder = self._service.folder
        self._observer = Caller(self._folder.control_socket)
        self._observer.ask(write_control_message(Hello("observer")))
        self._slot = StateSlotReader(self._folder.state_slot)
        self._now_s, self._resting = 0.0, True
        self._events: list[dict[str, Any]] = []
        self._ended: list[dict[str, Any]] = []

    def run(self) -> KillRecord:
        hung: subprocess.Popen[bytes] | None = None
        try:
            self._wait(self._commanded, "an executive attaches")
            self._wait(self._keeps_up, "the control process keeps up")
            self._send(SENTENCE)
            motion = self._wait_for_instant()
            victim = self._service.executive
            if self._hang:
                hung = victim
            before_s = self._look()
            victim.send_signal(signal.SIGSTOP if self._hang else signal.SIGKILL)
            return self._judge(before_s, motion)
        finally:
            if hung is not None:
                hung.kill()
                hung.wait()
            self._end()

    def _judge(self, killed_s: float, motion: str) -> KillRecord:
        seen = len(self._events)
        stop = None
        self._wait(lambda: self._look() > killed_s + HANG_WITHIN_S + 0.2, "the watchdog's time is over")
        for event in self._events[seen:] + self._events[:seen]:
            if event["event"] == "StopStarted" and event["t_s"] >= killed_s - 0.011:
                stop = event
                break
        self._wait(lambda: (self._look() > 0.0) and self._resting, "the robot rests")
        rest_s = self._now_s - killed_s
        self._evaluate(write_message("pace", pace=0.0))
        until_s = self._now_s + STANDS_S
        self._wait(lambda: self._look() > until_s, "it stands for a while")
        fallen = bool(self._evaluate(write_message("truth"))["fallen"])
        self._evaluate(write_message("pace", pace=self._pace))
        self._service.start_another_executive()
        self._wait(self._commanded, "a new executive attaches")
        resumed, line = self._carry_out(AFTERWARDS)
        fallen = fallen or bool(self._evaluate(write_message("truth"))["fallen"])
        status = self._status()
        record = KillRecord(
            seed=self._seed,
            signal="SIGSTOP" if self._hang else "SIGKILL",
            outcome="stood",
            motion=motion,
            braking_s=None if stop is None else max(0.0, stop["t_s"] - killed_s),
            rest_s=rest_s,
            refused=status["setpoints"]["refused"],
            fallen=fallen,
            resumed=resumed,
            t_s=killed_s,
            late_p99_ms=status["lateness"]["p99_ms"],
            lost_s=status["lateness"]["lost_s"],
            detail=line,
        )
        return _judged(record)

    # ---------------------------------------------------------------- the robot, from outside

    def _wait_for_instant(self) -> str:
        """Wait for a random instant of a random motion; names it, or nothing when the task has ended."""
        wanted = int(self._rng.integers(1, _MOTIONS + 1))
        offset_s = float(self._rng.uniform(0.05, 1.2))
        self._wait(lambda: len(self._started()) >= wanted or self._idle(), "the motion begins")
        began_s = self._look()
        self._wait(lambda: self._look() > began_s + offset_s, "the instant comes")
        running = self._status()["motions"]
        return str(running[0]) if running else ""

    def _started(self) -> list[dict[str, Any]]:
        self._look()
        return [event for event in self._events if event["event"] == "MotionStarted"]

    def _idle(self) -> bool:
        """Whether the task was done before the motion that was waited for.

        Raises:
            LiveError: It was not done.
        """
        self._ended += self._task.arrived("result")
        if self._ended and _OVERLOADED in self._ended[0]["text"]:  # the machine, not the robot: say it again
            self._ended.clear()
            self._wait(self._keeps_up, "the control process keeps up")
            self._send(SENTENCE)
        if self._ended and self._ended[0]["exit_code"] != 0:
            raise LiveError(f"the task did not come so far: {self._ended[0]['text']}")
        return bool(self._ended)

    def _keeps_up(self) -> bool:
        self._wall.sleep(0.1)
        return not self._status()["reservations"]

    def _look(self) -> float:
        """Take in what has been told; returns control time."""
        self._events += self._observer.arrived("event")
        row = self._slot.newest()
        if row is not None:
            self._now_s, self._resting = float(row[0]), bool(row[1])
        return self._now_s

    def _wait(self, condition: Callable[[], bool], what: str) -> None:
        until_s = self._wall.now_s() + _TASK_WALL_S
        while not condition():
            if self._service.control.poll() is not None:
                raise LiveError("the control process ended")
            if self._wall.now_s() > until_s:
                raise LiveError(f"in vain: {what}")
            self._wall.sleep(_LOOK_S)

    def _status(self) -> dict[str, Any]:
        caller = Caller(self._folder.control_socket)
        try:
            return caller.ask(write_control_message(GetStatus()), within_s=20.0)
        finally:
            caller.close()

    def _commanded(self) -> bool:
        self._wall.sleep(0.1)
        if not self._folder.executive_socket.exists():
            return False
        return bool(self._status()["commander"] == self._service.executive.pid)

    def _evaluate(self, message: bytes) -> dict[str, Any]:
        caller = Caller(self._folder.evaluation_socket)
        try:
            return caller.ask(message, within_s=20.0)
        finally:
            caller.close()

    def _send(self, sentence: str) -> Caller:
        caller = Caller(self._folder.executive_socket)
        caller.send(write_desk_message(Say(sentence)))
        self._task = caller  # its end would cancel the task
        return caller

    def _carry_out(self, sentence: str) -> tuple[bool, str]:
        result: dict[str, Any] = {}

        def take(answer: dict[str, Any]) -> bool:
            if answer["type"] in ("result", "error"):
                result.update(answer)
            return bool(result)

        for _ in range(_TRIES):
            result.clear()
            self._send(sentence).listen(take, _TASK_WALL_S)
            if _OVERLOADED not in str(result.get("text")):
                break
            self._wait(self._keeps_up, "the control process keeps up")
        return result.get("exit_code") == 0, str(result.get("text", result))

    def _end(self) -> None:
        try:
            Caller(self._folder.control_socket).ask(write_control_message(Shutdown()))
            self._service.control.wait(20.0)
        except (LiveError, subprocess.TimeoutExpired):
            self._service.control.kill()
            self._service.control.wait()
        self._service.close()


def _judged(record: KillRecord) -> KillRecord:
    if record.fallen:
        return replace(record, outcome="fell")
    if not record.in_time or record.refused:
        return replace(record, outcome="not stopped")
    return record if record.resumed else replace(record, outcome="not resumed")
