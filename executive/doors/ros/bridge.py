"""The bridge between ROS on the wire and a served robot: a process beside it, in no loop of its control."""

from __future__ import annotations

import os
import queue
import threading
from collections.abc import Callable, Mapping
from contextlib import closing
from functools import partial
from pathlib import Path
from typing import Any

from executive.doors.ros.camera import CameraTopics, StateStamps
from executive.doors.ros.graph import RosNode, best_effort, reliable, taken
from executive.doors.ros.messages import (
    Bool,
    Detection3DArray,
    DiagnosticArray,
    Imu,
    JointState,
    Odometry,
    String,
    TFMessage,
    Time,
    Twist,
    TwistStamped,
    WrenchStamped,
)
from executive.doors.ros.publishing import StateMessages, detections, diagnostics
from executive.doors.ros.settings import RosSettings
from executive.doors.served_robot import RESET_IS_A_PERSONS, Run, ServedRobot
from executive.doors.velocity_flow import VelocityFlow
from executive.errors import UserError
from executive.live.caller.caller import Caller
from executive.live.desk_messages import Listen, write_desk_message
from executive.scripts.task_script import is_script
from kinematics.model.robot_model import RobotModel
from robots.clock import WallClock, utc_ns
from robots.live.documents.robot_report import ReportLayout, RobotReport
from robots.live.wire.errors import LiveError
from robots.live.wire.runtime_folder import RuntimeFolder
from robots.live.wire.state_slot import StateSlotReader
from robots.models.description import load_description

_POLL_S = 0.002
_TRANSFORMS_EVERY_S, _STATUS_EVERY_S, _SCENE_EVERY_S = 0.02, 1.0, 0.5
_STOP_POLL_S = 0.005
_ENGAGED_FOR_S = 0.5
"""Messages that repeat an emergency stop within this time stop again, and are not told again."""
_MOST_QUEUED = 20
_READY_WITHIN_S = 120.0


class Commands:
    """What comes from ROS: sentences, answers and emergency stops.

    Each waits for the robot in a thread of its own, the stop's beside the others': a stop waits for nobody.

    Args:
        node: Where the topics are.
        robot: Who is commanded.
        flow: Takes velocities.
        tell: Publishes a line on ``/ai/status``.
    """

    def __init__(
        self, node: RosNode, robot: ServedRobot, flow: VelocityFlow, tell: Callable[[str], None]
    ) -> None:
        self._flow = flow
        self._twists = node.reader("/cmd_vel", Twist, best_effort(1))
        self._stamped = node.reader("/cmd_vel", TwistStamped, best_effort(1))
        self._robot, self._tell, self._wall = robot, tell, WallClock()
        self._commands = node.reader("/ai/command", String, reliable())
        self._answers = node.reader("/ai/answer", String, reliable())
        self._stops = [
            node.reader("/emergency_stop", Bool, policies) for policies in (reliable(), best_effort())
        ]
        self._queued: queue.Queue[Callable[[], None]] = queue.Queue(_MOST_QUEUED)
        self._runs: list[tuple[Run, int]] = []
        self._lock = threading.Lock()
        threading.Thread(target=self._work, name="ros commands", daemon=True).start()
        self._ended = threading.Event()
        self._stop_watch = threading.Thread(target=self._watch_stops, name="ros stops", daemon=True)
        self._stop_watch.start()

    def close(self) -> None:
        """Take nothing in any more; a walk by velocities ends."""
        self._ended.set()
        self._stop_watch.join()
        self._flow.close()

    def poll(self) -> None:
        """Take in what has arrived, and pass on what the robot has said of its tasks."""
        for said in taken(self._commands):
            self._queue(partial(self._begin, said.data))
        for said in taken(self._answers):
            self._queue(partial(self._answer, said.data))
        twists = [*taken(self._twists), *(one.twist for one in taken(self._stamped))]
        if twists:
            self._drive(twists[-1])
        self._flow.poll(self._wall.now_s())
        with self._lock:
            runs, self._runs = self._runs, []
        for run, seen in runs:
            ended = run.ended
            lines, count = run.news(seen)
            for line in lines:
                self._tell(line)
            if not ended:
                with self._lock:
                    self._runs.append((run, count))

    def _drive(self, asked: Twist) -> None:
        """Pass a velocity on; this robot walks ahead and back and turns, and nothing else."""
        other = any((asked.linear.y, asked.linear.z, asked.angular.x, asked.angular.y))
        why = (
            "only linear.x and angular.z may differ from zero: this robot does not walk sideways"
            if other
            else ""
        )
        self._flow.hear(asked.linear.x, asked.angular.z, self._wall.now_s(), why)

    def _queue(self, work: Callable[[], None]) -> None:
        try:
            self._queued.put_nowait(work)
        except queue.Full:
            self._tell("refused: more commands at once than are taken; wait for the first to be answered")

    def _work(self) -> None:
        while True:
            work = self._queued.get()
            try:
                work()
            except (LiveError, UserError) as wrong:
                self._tell(f"refused: {wrong}")

    def _begin(self, text: str) -> None:
        if text.strip().lower() == "reset":
            self._tell(f"refused: {RESET_IS_A_PERSONS}")
            return
        run = self._robot.begin_script(text) if is_script(text) else self._robot.begin(text)
        with self._lock:
            self._runs.append((run, 0))

    def _answer(self, text: str) -> None:
        if not self._robot.answer(text):
            self._tell("refused: no question is open")

    def _watch_stops(self) -> None:
        quiet_until_s = 0.0
        while not self._ended.is_set():
            self._wall.sleep(_STOP_POLL_S)
            if not any(said.data for reader in self._stops for said in taken(reader)):
                continue
            try:
                self._robot.stop("/emergency_stop")
            except LiveError as wrong:
                self._tell(f"failed: the emergency stop did not reach the robot: {wrong}")
                continue
            told, quiet_until_s = self._wall.now_s() < quiet_until_s, self._wall.now_s() + _ENGAGED_FOR_S
            if not told:
                self._tell(f"emergency stop engaged by /emergency_stop; {RESET_IS_A_PERSONS}")


class Publications:
    """What goes to ROS: the robot's state, its frames, what it believes, how it stands.

    Args:
        node: Where the topics are.
        model: The robot.

    Attributes:
        stamps: Of the states that were published.
    """

    def __init__(self, node: RosNode, model: RobotModel) -> None:
        self._model, self._messages, self._wall = model, StateMessages(model.description), WallClock()
        self._joints = node.writer("/joint_states", JointState, reliable())
        self._odometry = node.writer("/odom", Odometry, reliable())
        self._imu = node.writer("/imu", Imu, reliable())
        self._wrenches = [
            node.writer(f"/wrench/{sole.frame}", WrenchStamped, reliable())
            for sole in model.description.soles
        ]
        self._frames = node.writer("/tf", TFMessage, reliable(100))
        self._fixed = node.writer("/tf_static", TFMessage, reliable(1, latched=True))
        self._fixed.write(self._messages.fixed_transforms(_now()))
        self._described = node.writer("/robot_description", String, reliable(1, latched=True))
        self._described.write(String(model.description.urdf))
        self._diagnostics = node.writer("/diagnostics", DiagnosticArray, reliable())
        self._detections = node.writer("/detections", Detection3DArray, reliable())
        self._frames_at_s = 0.0
        self.stamps = StateStamps()

    def state(self, report: RobotReport) -> None:
        """Publish a new state."""
        stamp, messages = _now(), self._messages
        self.stamps.note(report.t_s, stamp)
        self._joints.write(messages.joints(report, stamp))
        self._odometry.write(messages.odometry(report, stamp))
        if (imu := messages.imu(report, stamp)) is not None:
            self._imu.write(imu)
        for writer, wrench in zip(self._wrenches, messages.wrenches(report, stamp), strict=True):
            writer.write(wrench)
        if self._wall.now_s() >= self._frames_at_s:
            self._frames_at_s = self._wall.now_s() + _TRANSFORMS_EVERY_S
            self._frames.write(messages.transforms(report, stamp))

    def status(self, told: Mapping[str, Any]) -> None:
        """Publish how things stand."""
        self._diagnostics.write(diagnostics(told, self._model.description, _now()))

    def scene(self, things: list[dict[str, Any]]) -> None:
        """Publish what is believed."""
        self._detections.write(detections(things, _now()))


def bridge(folder: Path, settings: RosSettings, ended: Callable[[], bool]) -> None:
    """Bridge a served robot until something says that it ends.

    Args:
        folder: Where it is served.
        settings: Where it is in ROS.
        ended: Asked in between.

    Raises:
        LiveError: No robot is served there.
    """
    robot, wall = ServedRobot(folder), WallClock()
    told, where = _served(robot, wall, ended), RuntimeFolder(folder)
    model = RobotModel(load_description(str(told["robot"])))
    layout, slot = ReportLayout(model), StateSlotReader(where.state_slot)
    node = RosNode(settings)
    status = node.writer("/ai/status", String, reliable(100))

    def tell(line: str) -> None:
        status.write(String(line))

    commands = Commands(node, robot, VelocityFlow(folder, tell), tell)
    publications = Publications(node, model)
    camera = None
    if told.get("perception") == "rgbd":
        camera = CameraTopics(node, where.picture_slot, publications.stamps)
        camera.begin(wall)
    asks = threading.Thread(target=_ask, args=(robot, publications, wall), name="ros status", daemon=True)
    asks.start()
    threading.Thread(target=_listen, args=(folder, tell, wall), name="ros listener", daemon=True).start()
    try:
        while not ended():
            row = slot.newest()
            if row is not None:
                publications.state(layout.report(row))
            commands.poll()
            wall.sleep(_POLL_S)
    finally:
        commands.close()
        if camera is not None:
            camera.close()


def _served(robot: ServedRobot, wall: WallClock, ended: Callable[[], bool]) -> Mapping[str, Any]:
    """What the robot tells of itself, once its executive is there: it begins after the control."""
    while True:
        try:
            return robot.status()
        except LiveError:
            if ended() or wall.now_s() > _READY_WITHIN_S:
                raise
            wall.sleep(_STATUS_EVERY_S)


def _ask(robot: ServedRobot, publications: Publications, wall: WallClock) -> None:
    """Ask how things stand and what is believed, now and then."""
    asked_s = -_STATUS_EVERY_S
    while True:
        try:
            if wall.now_s() - asked_s >= _STATUS_EVERY_S:
                asked_s = wall.now_s()
                publications.status(robot.status())
            publications.scene(robot.scene())
        except LiveError as gone:
            publications.status({"defects": [str(gone)]})
        wall.sleep(_SCENE_EVERY_S)


def _listen(folder: Path, tell: Callable[[str], None], wall: WallClock) -> None:
    """Tell what others are told of orders given elsewhere; of its own ones the bridge tells already."""
    mine = os.getpid()

    def take(said: dict[str, Any]) -> bool:
        if said["type"] == "heard" and said["by"] != mine:
            tell(said["text"])
        return False

    while True:
        try:
            with closing(Caller(RuntimeFolder(folder).executive_socket)) as caller:
                caller.send(write_desk_message(Listen()))
                caller.listen(take)
        except LiveError:
            wall.sleep(_SCENE_EVERY_S)  # until another executive takes the place of the one that ended


def _now() -> Time:
    sec, nanosec = divmod(utc_ns(), 1_000_000_000)
    return Time(sec, nanosec)
