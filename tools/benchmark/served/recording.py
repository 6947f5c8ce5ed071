"""The recorder: what a run loses when any process of it is killed, and what recording costs the control."""

from __future__ import annotations

import os
import signal
import tempfile
from pathlib import Path

import numpy as np
from rosbags.highlevel import AnyReader

from executive.doors.recorder.mend import mend
from executive.doors.recorder.parts import MotionParts
from executive.doors.view.motion_read import recording_in
from robots.clock import WallClock
from robots.live.wire.state_slot import StateSlotReader
from tools.benchmark.figures import Figure, figure
from tools.benchmark.served.served_robot import (
    CONTROL,
    EXECUTIVE,
    RECORDER,
    Measured,
    Moving,
    processor_s,
    served,
    wait,
)

VICTIMS = {"recorder": RECORDER, "executive": EXECUTIVE, "control": CONTROL, "what serves": ""}
_LOST_WITHIN_S = 30.0
_PHASE_S = 5.0
_SEED = 5


def recording(quick: bool) -> list[Figure]:
    """What is lost, victim by victim, then what it costs."""
    wall, rng = WallClock(), np.random.default_rng(_SEED)
    lasts_s, times = (4.0, 1) if quick else (60.0, 5)
    found = []
    for victim, module in VICTIMS.items():
        lost = [_lost_ms(module, lasts_s, float(rng.uniform(0.6, 0.9)), wall) for _ in range(times)]
        found.append(figure(f"lost of a run of {lasts_s:.0f} s, ms: {victim} killed, worst", [max(lost)]))
    with tempfile.TemporaryDirectory(prefix="recording-") as folder, served(Path(folder), wall) as measured:
        found += _cost(measured, wall, 2 if quick else 20)
    return found


def _lost_ms(module: str, lasts_s: float, share: float, wall: WallClock) -> float:
    """Control time in ms from the last state that was kept to the one at which a process was killed.

    Args:
        module: Of the process; empty for the one that serves.
        lasts_s: How long the run is to last.
        share: Of the run after which it is killed.
    """
    with tempfile.TemporaryDirectory(prefix="recording-") as folder, served(Path(folder), wall) as measured:
        slot = StateSlotReader(measured.where.state_slot)
        measured.robot.begin(f"wait for {lasts_s:.0f} seconds")
        wait(lambda: bool(_parts(measured)), wall)
        wall.sleep(share * lasts_s)
        victim = measured.pid(module) if module else measured.serve.pid
        killed_s = _newest_s(slot)
        os.kill(victim, signal.SIGKILL)
        part = _parts(measured)[0]
        # a recorder that lives goes on for a little, or ends its file: what it had not written yet
        wait(lambda: not _goes_on(part, wall), wall, _LOST_WITHIN_S)
        kept_s = recording_in(part).ends_s
        mend(part)
        with AnyReader([part]) as reader:
            if not reader.message_count:
                raise AssertionError(f"{part}: rosbags reads nothing")
        return 1e3 * max(killed_s - kept_s, 0.0)


def _parts(measured: Measured) -> list[Path]:
    return [part for run in measured.runs.glob("*/run.json") for part in MotionParts(run.parent).all()]


def _newest_s(slot: StateSlotReader) -> float:
    row = slot.newest()
    if row is None:
        raise AssertionError("no state was told")
    return float(row[0])


def _goes_on(part: Path, wall: WallClock) -> bool:
    before = part.stat().st_size
    wall.sleep(1.0)
    return part.stat().st_size != before


def _cost(measured: Measured, wall: WallClock, turns: int) -> list[Figure]:
    """The control's time and lateness while the recorder works and while it is held."""
    recorder, control = measured.pid(RECORDER), measured.pid(CONTROL)
    shares: dict[bool, list[float]] = {True: [], False: []}
    late: dict[bool, list[float]] = {True: [], False: []}
    with Moving(measured.robot, wall):
        for turn in range(2 * turns):
            works = turn % 2 == 0
            os.kill(recorder, signal.SIGCONT if works else signal.SIGSTOP)
            wall.sleep(0.5)
            before, began_s = processor_s(control), wall.now_s()
            late[works].append(measured.late_share(wall, _PHASE_S))
            shares[works].append(100.0 * (processor_s(control) - before) / (wall.now_s() - began_s))
        os.kill(recorder, signal.SIGCONT)
    peer = "while the recorder is held"
    return [
        figure("share of a core of the control while recorded, %", shares[True], peer, shares[False]),
        figure("periods late, % while recorded", late[True], peer, late[False]),
    ]
