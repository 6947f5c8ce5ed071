"""A session on a served robot: attach, carry out what the desk takes in, heartbeat all the while."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import IO, Any, cast

import numpy as np

from executive.command_parser import parse
from executive.events import Event
from executive.exit_codes import ExitCode
from executive.feedback import result_line, result_line_of_all
from executive.live.control_link import ControlLink, ControlLostError
from executive.live.desk import Desk, Order, Say
from executive.live.live_steps import DetectorClient, LiveClock, LiveSteps
from executive.live.motion_client import GripperClient, MotionClient
from executive.live.planning_client import LivePlanning, Worker
from executive.meaning import Command, Parsed, StopCommand
from executive.outputs.display import PlainDisplay
from executive.outputs.report import Report, SafetyCounts
from executive.run_log import RunLog
from executive.session import TASK_TIMEOUT_S, Session
from executive.task_result import TaskResult
from kinematics.robot_model import RobotModel
from robots.live.runtime_folder import RuntimeFolder
from trees.build import NoSkillError, TaskTree, has_skill
from trees.tasks import MoveTask
from trees.toolbox import Toolbox
from trees.world_model import WorldModel

_IDLE_S = 0.02


class LiveExecutive:
    """One attachment to a control process; ends with it.

    Args:
        folder: Where the robot is served.
        model: Its model.
        planning: The planning process.
        world: What is believed of the world; outlives an attachment.
        record: Folder of the recorded runs.
    """

    def __init__(
        self, folder: RuntimeFolder, model: RobotModel, planning: Worker, world: WorldModel, record: Path
    ) -> None:
        """Attach.

        Raises:
            LiveError: The control process does not take this process as its commander.
        """
        self._link = link = ControlLink(folder, model)
        self._record = record
        self._order: Order | None = None
        self._log: RunLog | None = None
        self._display: PlainDisplay | None = None
        self._stops: tuple[str, ...] = ()
        link.listen(self._note)
        motion = MotionClient(link)
        detector = DetectorClient(link)
        self._desk = Desk(folder.executive_socket, self._cancel, self.status, _is_stop)
        self._steps = LiveSteps(link, detector, world, self._meanwhile)
        self._planning = LivePlanning(planning, link, motion, world, self._note)
        rng = np.random.default_rng(np.random.SeedSequence(int(link.about["seed"])).spawn(3)[2])
        toolbox = Toolbox(
            clock=LiveClock(link),
            model=model,
            motion=motion,
            sensing=self._steps.sensing,
            grippers={hand: GripperClient(link, motion, hand) for hand in model.description.grippers},
            detector=detector,
            planning=self._planning,
            world=world,
            events=self._note,
            rng=rng,
        )
        self._session = Session(toolbox, self._steps, self._planning, self._note, on_tick=self._show)

    def run(self) -> None:
        """Carry out order after order.

        Raises:
            ControlLostError: The connection to the control process has ended.
        """
        try:
            while True:
                order = self._desk.next_order()
                if order is None:
                    self._session.hold(_IDLE_S)
                    self._desk.poll()
                    continue
                try:
                    self._carry_out(order)
                finally:
                    self._desk.finish()
        except ControlLostError as lost:
            if self._order is not None:
                self._order.end(f"failed: {lost}", "failed", ExitCode.FAILED)
            raise

    def close(self) -> None:
        """Let go: what moves is braked by the control process."""
        self._desk.poll()
        self._desk.close()
        self._link.close()

    def status(self) -> Mapping[str, Any]:
        """How things stand, as JSON values."""
        current = self._order.said.text if self._order is not None else None
        return {"task": current, "t_s": round(self._link.now_s, 3), "emergency": self._link.emergency or None}

    # ---------------------------------------------------------------- an order

    def _carry_out(self, order: Order) -> None:
        self._order, self._stops = order, ()
        self._display = PlainDisplay(cast(IO[str], _LineStream(order)))
        said = order.said
        about = self._link.about
        header = {key: about[key] for key in ("robot", "scene", "seed")}
        text = said.text or f"velocity {said.linear_m_s:g} m/s, {said.angular_rad_s:g} rad/s"
        try:
            with RunLog(self._record, {"input": text[:200], "live": True, **header}) as log:
                self._log = log
                line, outcome, code, results = self._results(said)
                report = Report(
                    input=text,
                    seed=int(about["seed"]),
                    robot=str(about["robot"]),
                    scene=str(about["scene"]),
                    outcome=outcome,
                    exit_code=code,
                    message=line,
                    events_sha256=log.digest.hexdigest(),
                    tasks=results,
                    safety=SafetyCounts(self._planning.checked, 0, self._stops),
                )
                log.finish(report.to_json())
            order.end(line, outcome, code)
        finally:
            self._order = self._log = self._display = None
            self._steps.busy = False

    def _results(self, said: Say) -> tuple[str, str, ExitCode, list[TaskResult]]:
        if self._link.emergency:
            engaged = f"refused: the emergency stop is engaged ({self._link.emergency}); `executive reset`"
            return engaged, "refused", ExitCode.UNSAFE, []
        parsed = _understood(said)
        if parsed.refusal is not None:
            return f"refused: {parsed.refusal}", "refused", ExitCode.INVALID, []
        if parsed.question is not None:
            return f"question: {parsed.question.text}", "question", ExitCode.QUESTION, []
        for command in parsed.commands:
            if not isinstance(command, StopCommand) and not has_skill(command):
                return f"refused: {NoSkillError(command)}", "refused", ExitCode.INVALID, []
        results: list[TaskResult] = []
        for command in parsed.commands:
            results.append(self._run(command, said.timeout_s or TASK_TIMEOUT_S))
            if results[-1].outcome != "done":
                break
        last = results[-1]
        if len(results) == 1:
            return result_line(last), last.outcome, last.exit_code, results
        return result_line_of_all(results), last.outcome, last.exit_code, results

    def _run(self, command: Command, timeout_s: float) -> TaskResult:
        self._steps.busy = True
        try:
            return self._session.run_task(command, timeout_s)
        finally:
            self._steps.busy = False

    # ---------------------------------------------------------------- on the way

    def _meanwhile(self) -> None:
        self._desk.poll()
        if self._link.emergency and self._steps.busy:
            self._cancel(f"emergency stop: {self._link.emergency}")

    def _cancel(self, reason: str) -> None:
        self._session.cancel(reason)

    def _note(self, event: Event) -> None:
        if self._log is not None:
            self._log.add(event)
        if self._display is not None:
            self._display.event(event)
        if type(event).__name__ == "StopStarted":
            self._stops = (*self._stops, str(getattr(event, "reason", "")))

    def _show(self, tree: TaskTree) -> None:
        if self._display is not None:
            self._display.tick(tree)


class _LineStream:
    """Where a display writes lines to: back to who gave the order."""

    encoding = "utf-8"

    def __init__(self, order: Order) -> None:
        self._order = order

    def write(self, text: str) -> int:
        self._order.tell(text.rstrip("\n"))
        return len(text)

    def flush(self) -> None:
        pass


def _understood(said: Say) -> Parsed:
    if said.text:
        return parse(said.text)
    text = f"move at {said.linear_m_s:g} m/s and {said.angular_rad_s:g} rad/s"
    return Parsed(text, (MoveTask(text, said.linear_m_s, said.angular_rad_s),))


def _is_stop(text: str) -> bool:
    commands = parse(text).commands
    return len(commands) == 1 and isinstance(commands[0], StopCommand)
