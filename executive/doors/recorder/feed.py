"""Tells the process that records a run in lockstep what goes on.

The run waits for that process where it is slow, so that little is under way between the two when either is
killed; one that takes nothing any more is given up, and the run goes on.
"""

from __future__ import annotations

import fcntl
import json
import os
import select
import subprocess
import sys
import tempfile
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from executive.doors.companion import MissingExtraError, require_extra
from executive.doors.recorder.parts import MotionParts
from executive.doors.recorder.told_apart import EVENT, TREE, WORLD, json_frame, state_frame
from executive.live.told_as_json import tree_json
from executive.live.world_as_json import believed_json
from executive.reports.feedback import line_for
from executive.screens.display import Display
from executive.session.events import Event, TaskEnded, event_json
from robots.live.documents.robot_report import ReportLayout, RobotReport, landings_of

if TYPE_CHECKING:
    from executive.session.assembly import Assembly
    from robots.control.loop.control_loop import ControlLoop
    from trees.build import TaskTree

_STATE_EVERY_S, _TREE_EVERY_S = 0.01, 0.1
_EARLY_S = 0.001
_PIPE_BYTES = 16 * 1024
"""What is in the pipe is lost with the process that reads it: a few states."""
_GIVEN_UP_AFTER_S = 20.0
_ENDS_WITHIN_S = 60.0


def complaint_without_extra() -> str | None:
    """Why no motion can be recorded, for people; None where what that needs is installed."""
    try:
        require_extra("record", "mcap", "cyclonedds")
    except MissingExtraError as missing:
        return f"the run's motion is not recorded: {missing}"
    return None


class RunFeed:
    """A display that records what another one shows; satisfies ``executive.screens.display.Display``.

    Args:
        display: Shows the run.
        complain: Takes a line for people where the motion is not recorded, or not all of it.
    """

    def __init__(self, display: Display, complain: Callable[[str], None]) -> None:
        self._display, self._complain = display, complain
        self._process: subprocess.Popen[bytes] | None = None
        self._pipe: int | None = None
        self._assembly: Assembly | None = None
        self._layout: ReportLayout | None = None
        self._tree: TaskTree | None = None
        self._state_due_s = self._tree_due_s = 0.0
        self._seen_of: object = None
        self._place: tempfile.TemporaryDirectory[str] | None = None

    def record(self, folder: Path, header: Mapping[str, Any]) -> Path:
        """Begin to record in the folder of a run; returns where pictures are to be shown."""
        self._place = tempfile.TemporaryDirectory(prefix="executive-record-", ignore_cleanup_errors=True)
        slot = Path(self._place.name) / "picture"
        self.open(MotionParts(folder).next(), header, slot=slot)
        return slot

    def open(self, path: Path, header: Mapping[str, Any], zero_ns: int = 0, slot: Path | None = None) -> None:
        """Begin to record.

        Args:
            path: Of the MCAP file; it is not there yet.
            header: Whose run it is, as its ``run.json``.
            zero_ns: Wall time since 1970 at which it began; 0 is now.
            slot: Where the newest picture of the robot's camera is shown; None for nowhere.
        """
        about = json.dumps({key: str(header.get(key, "")) for key in ("input", "robot", "scene", "seed")})
        command = [sys.executable, "-m", "executive.doors.recorder.fed_process"]
        command += [os.fspath(path), str(header["robot"]), about, str(zero_ns)]
        command += [] if slot is None else [os.fspath(slot)]
        try:
            self._process = process = subprocess.Popen(command, stdin=subprocess.PIPE, start_new_session=True)
        except OSError as failed:
            self._complain(f"the run's motion is not recorded: {failed.strerror or failed}")
            return
        if process.stdin is not None:
            self._pipe = process.stdin.fileno()
            os.set_blocking(self._pipe, False)
            fcntl.fcntl(self._pipe, fcntl.F_SETPIPE_SZ, _PIPE_BYTES)

    def begin(self, assembly: Assembly) -> None:
        """Look at a robot from now on."""
        self._assembly, self._layout = assembly, ReportLayout(assembly.model)
        assembly.session.watch_periods(self._period)

    def event(self, event: Event) -> None:
        """Record it, and show it."""
        if self._pipe is not None:
            self._tell(json_frame(EVENT, {"told": event_json(event), "line": line_for(event)}))
            if isinstance(event, TaskEnded):
                self._tell_tree(event.t_s)  # as it has ended
        self._display.event(event)

    def tick(self, tree: TaskTree) -> None:
        """Know the tree under way, and show it."""
        self._tree = tree
        self._display.tick(tree)

    def note(self, line: str) -> None:
        """Show it."""
        self._display.note(line)

    def close(self) -> None:
        """Show nothing more, and wait until all is recorded."""
        self._display.close()
        process, self._pipe, self._process = self._process, None, None
        if process is None or process.stdin is None:
            return
        process.stdin.close()
        try:
            code = process.wait(_ENDS_WITHIN_S)
        except subprocess.TimeoutExpired:
            process.kill()
            code = process.wait()
        if self._place is not None:
            self._place.cleanup()
        if code < 0:
            self._complain("what records the run's motion was ended before its end; the rest is kept")

    def _period(self) -> None:
        assembly, layout = self._assembly, self._layout
        if assembly is None or layout is None or self._pipe is None:
            return
        t_s = assembly.clock.now_s()
        if t_s < self._state_due_s - _EARLY_S:
            return
        self._state_due_s = t_s + _STATE_EVERY_S
        self._tell(state_frame(layout.row(report_of(assembly.loop, t_s))))
        world = assembly.session.toolbox.world
        planned = assembly.loop.motion.planned
        if (now := (world.scene.version, world.sightings, id(planned))) != self._seen_of:
            self._seen_of = now
            believed = believed_json(assembly.session.toolbox, planned)
            self._tell(json_frame(WORLD, {"t_s": t_s, "world": believed}))
        if t_s >= self._tree_due_s:
            self._tree_due_s = t_s + _TREE_EVERY_S
            self._tell_tree(t_s)

    def _tell_tree(self, t_s: float) -> None:
        """Tell how the tree stands."""
        if self._tree is not None:
            self._tell(json_frame(TREE, {"t_s": t_s, "nodes": tree_json(self._tree.snapshot(t_s).root)}))

    def _tell(self, frame: bytes) -> None:
        """Write a frame; what reads them is waited for."""
        left = memoryview(frame)
        while left and self._pipe is not None:
            try:
                left = left[os.write(self._pipe, left) :]
            except BlockingIOError:
                if not select.select([], [self._pipe], [], _GIVEN_UP_AFTER_S)[1]:
                    self._pipe = None
                    self._complain(
                        "what records the run's motion takes nothing any more: the rest is not kept"
                    )
            except OSError:
                self._pipe = None  # it has ended, and has said why


def report_of(loop: ControlLoop, t_s: float) -> RobotReport:
    """What a robot in this process knows of itself, as one that is served tells it.

    Args:
        loop: Its control loop.
        t_s: Control time.
    """
    return RobotReport(
        t_s=t_s,
        resting=loop.motion.resting and not loop.walking.active,
        walking=loop.walking.active,
        sensed=loop.sensing.state(),
        reference=loop.motion.reference(),
        stance=loop.motion.stance(),
        grippers={hand: gripper.reading() for hand, gripper in loop.grippers.items()},
        landings=landings_of(loop.walking.landings),
    )
