"""The control process: ``python -m robots.live.process.control_process FOLDER …``; it owns the robot.

World, control loop, gate, emergency latch and watchdog live here, in a session of its own, so that neither
the end of the executive nor Ctrl-C in a terminal is the end of the robot's standing. A period that begins
late first lets the missed ones pass under the last setpoint, then reads what has arrived, then decides.
"""

from __future__ import annotations

import argparse
import contextlib
import dataclasses
import gc
import os
import signal
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from kinematics.errors import KinematicsError
from kinematics.model.robot_model import RobotModel
from robots.clock import ManualClock, WallClock
from robots.control.events import ControlEvent
from robots.control.loop.control_loop import ControlLoop
from robots.control.period import PERIOD_S
from robots.errors import RobotsError
from robots.live.documents.robot_report import ReportLayout, RobotReport, landings_of
from robots.live.process.condition import moves
from robots.live.process.control_server import ControlServer
from robots.live.process.evaluation_server import EvaluationServer
from robots.live.process.hold_back import HoldBack, processor_use
from robots.live.process.pacer import Pacer
from robots.live.process.site import BodySite, SimulatedSite, Site
from robots.live.process.supervision import Supervision
from robots.live.process.warming import warm_up
from robots.live.wire.child_process import ChildProcess
from robots.live.wire.runtime_folder import RuntimeFolder
from robots.live.wire.state_slot import StateSlotWriter
from robots.models.description import load_robot_for_tasks
from robots.scenes.scene_file import load_scene
from robots.seeded import Seeded

PUBLISH_EVERY = 5
"""Control periods between two states in the slot: 10 ms."""
_END_WITHIN_S = 3.0
"""Control time after which a shutdown does not wait for rest any longer."""
_PRIORITY = 20
_HELD_S = 0.005
_LOOK_EVERY = 100
"""Periods from one look for the supervisor to the next: 0.2 s."""
_FIRST_PERIODS = 50
"""Periods before anybody may connect."""


@dataclass(frozen=True, slots=True)
class ControlOptions:
    """What is served, and how.

    Attributes:
        folder: Where sockets and slot are.
        robot, scene, seed: As for ``executive run``.
        pace: Control time that passes in a second of wall time.
        realtime: Whether to ask for real-time scheduling; used only where it is permitted.
        evaluation: Whether evaluations may read the simulator's truth.
        supervisor: Process that started this one and replaces executives that end; None when none does.
        shown: Folder of things that were shown; None for none.
        perception: "stub" or "rgbd", whatever the scene says; None is what it says.
        body: How a body that is not simulated is attached; empty for one that is.
        body_options: Its own.
    """

    folder: Path
    robot: str
    scene: str
    seed: int
    pace: float = 1.0
    realtime: bool = True
    evaluation: bool = False
    supervisor: int | None = None
    shown: Path | None = None
    perception: str | None = None
    body: str = ""
    body_options: tuple[tuple[str, str], ...] = ()


class ControlProcess:
    """Everything of the control process, ready to run."""

    def __init__(self, options: ControlOptions) -> None:
        """Build the world and listen.

        Raises:
            RobotsError: Robot, scene or folder are no good.
        """
        folder = RuntimeFolder(options.folder)
        folder.make()
        self._lock = folder.hold()
        robot = load_robot_for_tasks(options.robot)
        description = robot.description
        scene = load_scene(options.scene).seen_by(options.perception)
        self._checker = ChildProcess("robots.live.process.admission_process", [options.robot])
        chance = Seeded.by(options.seed)
        model = RobotModel(description)
        self._clock = ManualClock()
        warm_up(model, robot.hardware)  # before there is a body that waits to be commanded
        try:
            self._site: Site = (
                BodySite(robot, options.body, dict(options.body_options))
                if options.body
                else SimulatedSite(robot, scene, self._clock, chance, options.shown, folder.picture_slot)
            )
        except BaseException:
            self._checker.close()
            raise
        self._server: ControlServer | None = None
        self._loop = ControlLoop(self._site.robot, model, self._clock, self._note, PERIOD_S)
        self._sight = self._site.sight(self._loop.sensing, model)
        self._pacer = Pacer(WallClock(), PERIOD_S, 0.0 if self._site.time_passes else options.pace)
        self._layout = ReportLayout(model)
        self._slot = StateSlotWriter(folder.state_slot, self._layout.count)
        self._scheduling = _real_time_scheduling() if options.realtime else "ordinary, as asked"
        self._defects, self._periods, self._told_defect = 0, 0, ""
        self._hold = HoldBack(WallClock(), processor_use)
        self._supervision = Supervision(options.supervisor)
        self._terminated = self._told_moving = False
        for _ in range(_FIRST_PERIODS):  # compiled code is loaded when it is first called
            self._step()
        self._publish()
        sight = self._sight
        about = {
            "robot": options.robot,
            "scene": options.scene,
            "perception": self._site.kind,
            "labels": None if sight.detector.labels is None else sorted(sight.detector.labels),
            "fronts": sorted(sight.detector.fronts),
            "seed": options.seed,
            "period_s": PERIOD_S,
            "state_every_s": PUBLISH_EVERY * PERIOD_S,
            "slot": os.fspath(folder.state_slot),
            "pid": os.getpid(),
        }
        self._server = ControlServer(
            folder.control_socket,
            self._loop,
            self._clock,
            sight.detector,
            self._checker,
            about,
            self._health,
            sight.ranging,
            sight.on_offer,
            sight.cameras,
        )
        self._evaluation = (
            EvaluationServer(folder.evaluation_socket, self._site.truth, self._pacer)
            if options.evaluation
            else None
        )

    def terminate(self) -> None:
        """End it as ``shutdown`` does; safe to call from a signal handler."""
        self._terminated = True

    def run(self) -> None:
        """Run until the end is asked for and the robot is at rest."""
        server = self._server
        if server is None:
            return
        gc.collect()
        gc.freeze()
        self._pacer.set_pace(self._pacer.pace)
        ending_s: float | None = None
        while True:
            missed = self._pacer.wait()
            if not self._site.time_passes:
                self._hold_back(server)
            self._loop.catch_up(missed, self._sight.tick)
            # within a period it is in time, as far as the robot can tell
            self._loop.note_late((missed + 1) * PERIOD_S if missed else 0.0)
            server.ending = server.ending or self._terminated
            server.poll()
            if self._evaluation is not None:
                self._evaluation.poll()
            self._step()
            if self._periods % _LOOK_EVERY == 0 and (news := self._supervision.news()) is not None:
                _say(news)
            if server.ending:
                if ending_s is None:
                    ending_s = self._clock.now_s()
                    self._loop.stop(1, "the robot is being shut down")
                if not moves(self._loop) or self._clock.now_s() > ending_s + _END_WITHIN_S:
                    server.poll()
                    break

    def close(self) -> None:
        """Take everything away."""
        if self._server is not None:
            self._server.close()
        if self._evaluation is not None:
            self._evaluation.close()
        self._checker.close()
        self._slot.close()
        os.close(self._lock)

    def _hold_back(self, server: ControlServer) -> None:
        """Let the world stand still while the commander gets no processor; everyone is heard meanwhile."""
        while self._hold.wanted(*server.silent_commander()):
            self._pacer.hold(_HELD_S)
            server.poll()

    def _step(self) -> None:
        try:
            self._loop.step()
        except Exception as defect:  # the loop has told the robot to stay where it is, and it must go on
            self._defects += 1
            if repr(defect) != self._told_defect:  # it may come again each period
                self._told_defect = repr(defect)
                _say(f"a defect of the control loop: {defect!r}")
        self._sight.tick()
        self._periods += 1
        # what has come to its end is in the slot before anybody is told of it
        if self._periods % PUBLISH_EVERY == 0 or moves(self._loop) != self._told_moving:
            self._publish()

    def _publish(self) -> None:
        motion, sensing = self._loop.motion, self._loop.sensing
        self._told_moving = moves(self._loop)
        report = RobotReport(
            t_s=self._clock.now_s(),
            resting=not self._told_moving,
            walking=self._loop.walking.active,
            sensed=sensing.state(),
            reference=motion.reference(),
            stance=motion.stance(),
            grippers={hand: gripper.reading() for hand, gripper in self._loop.grippers.items()},
            ending=self._loop.walking.ending,
            landings=landings_of(self._loop.walking.landings),
        )
        self._slot.write(self._layout.row(report))

    def _note(self, event: ControlEvent) -> None:
        if self._server is not None:
            self._server.note(event)

    def _health(self) -> dict[str, Any]:
        lateness = dataclasses.asdict(self._pacer.lateness())
        return {
            "scheduling": self._scheduling,
            "lateness": lateness,
            "loop_defects": self._defects,
            "supervisor": self._supervision.supervisor,
        }


def _real_time_scheduling() -> str:
    """Ask for it; tells what became of it. Children do not inherit it."""
    try:
        os.sched_setscheduler(0, os.SCHED_FIFO | os.SCHED_RESET_ON_FORK, os.sched_param(_PRIORITY))
    except OSError as refused:
        return f"ordinary (real-time scheduling: {refused.strerror})"
    return "real-time (SCHED_FIFO)"


def _say(line: str) -> None:
    with contextlib.suppress(OSError):  # nobody may be there to read it any more
        sys.stderr.write(f"executive: {line}\n")
        sys.stderr.flush()


def main() -> int:
    """Serve until the end; 2 when robot, scene or folder are no good."""
    parser = argparse.ArgumentParser(prog="python -m robots.live.process.control_process")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--robot", required=True)
    parser.add_argument("--scene", required=True)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--pace", type=float, default=1.0)
    parser.add_argument("--ordinary", action="store_true", help="do not ask for real-time scheduling")
    parser.add_argument("--evaluation", action="store_true")
    parser.add_argument("--supervisor", type=int, help="process that replaces executives that end")
    parser.add_argument("--shown", type=Path, help="folder of things that were shown")
    parser.add_argument("--perception", help="stub or rgbd, whatever the scene says")
    parser.add_argument("--body", default="", help="one that is not simulated")
    parser.add_argument("--body-option", nargs=2, action="append", default=[], metavar=("KEY", "VALUE"))
    asked = parser.parse_args()
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        process = ControlProcess(
            ControlOptions(
                asked.folder,
                asked.robot,
                asked.scene,
                asked.seed,
                asked.pace,
                not asked.ordinary,
                asked.evaluation,
                asked.supervisor,
                asked.shown,
                asked.perception,
                asked.body,
                tuple((key, value) for key, value in asked.body_option),
            )
        )
    except (RobotsError, KinematicsError, OSError) as wrong:
        _say(" ".join(str(wrong).split()))
        return 2
    for number in (signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, lambda _number, _frame: process.terminate())
    try:
        process.run()
    finally:
        process.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
