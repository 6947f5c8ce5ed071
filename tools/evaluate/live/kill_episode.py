"""One episode of suite ``kill``: a served robot whose executive is killed, or hangs, during a task."""

from __future__ import annotations

import signal
import subprocess
import tempfile
import traceback
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from tools.evaluate.live.served_robot import ServedRobot

KILL_WITHIN_S = 0.1
HANG_WITHIN_S = 1.1
"""Control time in which braking must begin; two control periods more for what is on its way."""
ON_ITS_WAY_S = 0.004
STANDS_S = 30.0
_ASKED_BEFORE_S = 0.1
"""What runs is asked for before the signal is sent."""
AFTERWARDS = "go home"


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
            return _run(ServedRobot(Path(folder), seed, robot, pace), seed, hang)
        except Exception:
            return KillRecord(seed, name, "error", detail=traceback.format_exc())


def _run(robot: ServedRobot, seed: int, hang: bool) -> KillRecord:
    hung: subprocess.Popen[bytes] | None = None
    try:
        robot.wait_until_ready()
        robot.send()
        motion = robot.wait_for_instant(np.random.default_rng([seed, hang]))
        victim = robot.service.executive
        if hang:
            hung = victim
        killed_s = robot.look()
        victim.send_signal(signal.SIGSTOP if hang else signal.SIGKILL)
        return _judge(robot, seed, hang, killed_s, motion)
    finally:
        if hung is not None:
            hung.kill()
            hung.wait()
        robot.end()


def _judge(robot: ServedRobot, seed: int, hang: bool, killed_s: float, motion: str) -> KillRecord:
    robot.wait(lambda: robot.look() > killed_s + HANG_WITHIN_S + 0.2, "the watchdog's time is over")
    stop = first_stop(robot, killed_s)
    robot.wait(lambda: robot.look() > 0.0 and robot.resting, "the robot rests")
    rest_s = robot.now_s - killed_s
    fallen = robot.stand(STANDS_S)
    robot.service.start_another_executive()
    robot.wait(robot.commanded, "a new executive attaches")
    code, line = robot.carry_out(AFTERWARDS)
    status = robot.status()
    if stop is None and _came_to_its_end(robot, killed_s, HANG_WITHIN_S if hang else KILL_WITHIN_S):
        motion = ""
    record = KillRecord(
        seed=seed,
        signal="SIGSTOP" if hang else "SIGKILL",
        outcome="stood",
        motion=motion,
        braking_s=None if stop is None else max(0.0, stop - killed_s),
        rest_s=rest_s,
        refused=status["setpoints"]["refused"],
        fallen=fallen or robot.fallen(),
        resumed=code == 0,
        t_s=killed_s,
        late_p99_ms=status["lateness"]["p99_ms"],
        lost_s=status["lateness"]["lost_s"],
        detail=line,
    )
    return _judged(record)


def _came_to_its_end(robot: ServedRobot, killed_s: float, within_s: float) -> bool:
    """Whether the motion was done by itself before anybody had to brake it."""
    return any(
        event["event"] == "MotionEnded"
        and event["status"] == "done"
        and killed_s - _ASKED_BEFORE_S <= event["t_s"] <= killed_s + within_s
        for event in robot.events
    )


def first_stop(robot: ServedRobot, since_s: float) -> float | None:
    """Control time of the first stop since an instant; the slot may be 10 ms old when that was read.

    Where a gripper alone moves nothing is braked: its motion is cancelled.
    """
    times = [
        event["t_s"]
        for event in robot.events
        if event["event"] == "StopStarted"
        or (event["event"] == "MotionEnded" and event["status"] == "canceled")
    ]
    return min((t_s for t_s in times if t_s >= since_s - 0.011), default=None)


def _judged(record: KillRecord) -> KillRecord:
    if record.fallen:
        return replace(record, outcome="fell")
    if not record.in_time or record.refused:
        return replace(record, outcome="not stopped")
    return record if record.resumed else replace(record, outcome="not resumed")
