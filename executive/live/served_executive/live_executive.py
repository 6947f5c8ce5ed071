"""A session on a served robot: attach, carry out what the desk takes in, heartbeat all the while."""

from __future__ import annotations

import gc
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import IO, Any, cast

from executive.config import config_files
from executive.dialogue.settle_words import settled
from executive.errors import NotWritableError, TrajectoryFileError
from executive.exit_codes import ExitCode
from executive.front.front_model import FrontModel
from executive.front.front_talk import FrontTalk
from executive.live.control_client.control_link import ControlLink, ControlLostError
from executive.live.control_client.jogging_client import JoggingClient
from executive.live.control_client.live_guard import LiveGuard
from executive.live.control_client.live_steps import DetectorClient, LiveClock, LiveSteps, RangingClient
from executive.live.control_client.motion_client import GripperClient, MotionClient
from executive.live.control_client.planning_client import LivePlanning, Worker
from executive.live.control_client.walking_client import WalkingClient
from executive.live.control_client.yielding_client import YieldingClient
from executive.live.desk_messages import FollowTrajectory, Jog, Script, TakeOver
from executive.live.jog_message import word_of
from executive.live.served_executive.desk import Desk, Order, name_of, question_json, statements_of
from executive.live.served_executive.desk import Said as DeskOrder
from executive.live.served_executive.given_trajectory import load_joint_motion
from executive.live.served_executive.known_place import known_of
from executive.live.served_executive.live_attendant import LiveAttendant
from executive.live.told_as_json import scene_json, tree_json
from executive.live.world_as_json import believed_json
from executive.manual.words import BY_HAND, ByHandTask, Ending
from executive.meaning import Command, Parsed, Refusal, StopCommand
from executive.robot_settings import robot_settings
from executive.runs.run_account import RunAccount, RunSubject
from executive.runs.run_log import RunLog
from executive.screens.display import PlainDisplay
from executive.scripts.script_run import Said, failed_command, run_statements, settle_all, verdict
from executive.session.controlled_robot import ControlledRobot, session_on
from executive.session.driver import driven
from executive.session.events import Event
from executive.session.task_result import TaskResult
from executive.trust import USUAL_TRUST, Trust
from executive.understanding.canonical_detector import CanonicalDetector, in_canonical_words
from executive.understanding.canonical_words import canonical_kind
from executive.understanding.command_parser import parse
from executive.understanding.conversation import Conversation
from executive.understanding.statement import Statement
from executive.vocabulary.in_a_place import words_of_the_place
from kinematics.model.robot_model import RobotModel
from robots.clock import local_time
from robots.live.documents.camera_message import cameras_of
from robots.live.wire.connection import Connection
from robots.live.wire.runtime_folder import RuntimeFolder
from robots.live.wire.unix_socket import UnixSocket
from robots.seeded import Seeded
from trees.build import TaskTree
from trees.failures import Failure
from trees.given_motion import FollowTrajectoryTask
from trees.readings.odometry import what_is_around
from trees.self_knowledge import Calendar
from trees.toolbox import VelocityFeed
from trees.world_model import WorldModel

_IDLE_S = 0.02


class LiveExecutive:
    """A served executive while it is attached to a control process; it ends with the attachment.

    Args:
        folder: Where the robot is served.
        model: Its model.
        planning: The planning process.
        world: What is believed of the world; outlives an attachment.
        record: Folder of the recorded runs.
        connection: Kind of the connection; a faulty one for evaluations.
        trust: How far a model's output is trusted.
        front: The language model in front, or None.
    """

    def __init__(
        self,
        folder: RuntimeFolder,
        model: RobotModel,
        planning: Worker,
        world: WorldModel,
        record: Path,
        connection: Callable[[UnixSocket], Connection] = Connection,
        trust: Trust = USUAL_TRUST,
        front: FrontModel | None = None,
    ) -> None:
        """Attach.

        Raises:
            LiveError: The control process does not take this process as its commander.
        """
        self._link = link = ControlLink(folder, model, connection)
        self._record, self._trust, self._front, self._model = record, trust, front, model
        self._failed: Command | None = None
        self._order: Order | None = None
        self._conversation = Conversation()
        self._account: RunAccount | None = None
        self._display: PlainDisplay | None = None
        self._tree: TaskTree | None = None
        self._last_tree: Sequence[Mapping[str, Any]] | None = None
        self._desk = Desk(folder.executive_socket, self, _is_stop)
        link.listen(self._note)
        self._motion = motion = MotionClient(link)
        detector = DetectorClient(link)
        self._velocities = VelocityFeed()
        ranging = RangingClient(link)
        self._steps = LiveSteps(link, detector, ranging, world, self._meanwhile)
        self._planning = LivePlanning(planning, link, motion, world, self._note)
        chance = Seeded.by(int(link.about["seed"]))
        placed = cameras_of(link.about["cameras"], partial(DetectorClient, link))
        served = ControlledRobot(
            model=model,
            clock=LiveClock(link),
            periods=self._steps,
            guard=LiveGuard(link),
            pausing=link,
            motion=motion,
            grippers={hand: GripperClient(link, motion, hand) for hand in model.description.grippers},
            walking=WalkingClient(link, motion),
            yielding=YieldingClient(link, motion, model, world),
            jogging=JoggingClient(link, motion, model),
            detector=CanonicalDetector(detector, canonical_kind),
            ranging=ranging,
            planning=self._planning,
            see_offer=link.offer,
            cameras=tuple(map(in_canonical_words, placed)),
        )
        places, people = known_of(str(link.about["scene"]), chance.places)
        settings = robot_settings(config_files())
        began = settings.begins or local_time()
        self._session, self._supervisor = session_on(
            served,
            self._note,
            chance,
            places,
            velocities=self._velocities,
            world=world,
            on_tick=self._show,
            identity=settings.identity,
            calendar=Calendar(began, served.clock.now_s()),
            people=people,
        )
        self._engaged = False

    def run(self) -> None:
        """Carry out order after order.

        Raises:
            ControlLostError: The connection to the control process has ended; who gave the order was told.
        """
        while True:
            order = self._desk.next_order()
            if order is None:
                self._session.hold(_IDLE_S)
                self._meanwhile()
                continue
            try:
                toolbox = self._session.toolbox
                told = toolbox.detector
                with words_of_the_place(told.labels or (), toolbox.people, told.fronts):
                    self._carry_out(order)
            finally:
                self._desk.finish()

    def close(self) -> None:
        """Let go: what moves is braked by the control process."""
        self._desk.poll()
        self._desk.close()
        self._link.close()

    def status(self) -> Mapping[str, Any]:
        """How things stand, as JSON values."""
        current = name_of(self._order.said) if self._order is not None else None
        state = self._supervisor.lifecycle.state.value
        paused = self._session.paused
        question, feed = self._desk.question, self._session.hands.feed
        return {
            "task": current,
            "t_s": round(self._link.now_s, 3),
            "state": state,
            "paused": paused,
            "question": question and question_json(question),
            "tree": self._tree_json(),
            "last_tree": None if self._tree else self._last_tree,
            "by_hand": feed.active,
            "held_back": feed.told,
        }

    def _tree_json(self) -> Sequence[Mapping[str, Any]] | None:
        return None if self._tree is None else tree_json(self._tree.snapshot(self._link.now_s).root)

    def scene(self) -> Sequence[Mapping[str, Any]]:
        """What the robot believes to be around it, as JSON values."""
        return scene_json(what_is_around(self._session.toolbox))

    def world(self) -> Mapping[str, Any]:
        """What is believed of the world, as JSON values."""
        return believed_json(self._session.toolbox, self._motion.planned)

    # ---------------------------------------------------------------- an order

    def _carry_out(self, order: Order) -> None:
        self._order = order
        self._display = display = PlainDisplay(cast(IO[str], _LineStream(order)))
        said, checked_before = order.said, self._planning.checked
        about = self._link.about
        subject = RunSubject(name_of(said), str(about["robot"]), str(about["scene"]), int(about["seed"]))
        try:
            with RunLog(self._record, {**subject.header(), "live": True}) as log:
                self._desk.watchers.run_begins(str(log.path))
                self._account = account = RunAccount(subject, log, display.event)
                lost: ControlLostError | None = None
                results: list[Said] = []
                try:
                    results = self._results(said)
                    ending = verdict([one for one, _ in results], results)
                except ControlLostError as gone:
                    lost, ending = gone, (f"failed: {gone}", "failed", ExitCode.FAILED)
                account.close(ending, results, self._planning.checked - checked_before)
            order.end(*ending, run=str(log.path))
            if lost is not None:
                raise lost
        except NotWritableError as wrong:  # the disk has filled up since the last order
            order.end(f"refused: {wrong}", "refused", ExitCode.INVALID)
        except ControlLostError:
            raise
        except BaseException as ended:  # a defect, or a signal to end: nobody is left without an answer
            told = "the executive was ended" if isinstance(ended, SystemExit) else f"a defect: {ended!r}"
            order.end(f"failed: {told}", "failed", ExitCode.FAILED)
            raise
        finally:
            self._tell_tree(last=True)
            self._desk.watchers.run_ended()
            self._last_tree = self._tree_json() or self._last_tree
            self._order = self._account = self._display = self._tree = None
            self._steps.busy = False
            gc.collect()  # a tree refers to itself, and holds what is large outside of Python

    def take_over(self) -> None:
        """Let a person have the task that is under way."""
        self._session.hands.feed.take_over()

    def hear_jog(self, message: Jog) -> None:
        """Take a word of the person who has the robot."""
        feed, word = self._session.hands.feed, word_of(message, self._model)
        feed.may_touch = message.may_touch
        if word is None:
            feed.brake()
        else:
            feed.say(word, self._link.now_s)

    def hand_back(self, ending: Ending) -> None:
        """Take the robot back from the person."""
        self._session.hands.feed.hand_back(ending)

    def hear_velocity(self, linear_m_s: float, angular_rad_s: float) -> None:
        """Walk at it, while such come."""
        self._velocities.hear(linear_m_s, angular_rad_s, self._link.now_s)

    def _results(self, said: DeskOrder) -> list[Said]:
        """Understand all of it, then carry it out."""
        session = self._session
        if isinstance(said, TakeOver):
            return self._by_hand()
        if isinstance(said, FollowTrajectory):
            return self._follow(said)
        attendant = LiveAttendant(self._desk, session.hold, lambda: session.interrupted)

        def waiting() -> bool:
            session.hold(_IDLE_S)
            self._desk.poll()
            return session.interrupted

        talk = None
        if self._front is not None:
            talk = FrontTalk(self._front, attendant.answer, self._note, waiting)
            talk.meet(session)

        def settle(understood: Statement) -> Statement | Failure:
            self._steps.busy = True
            if talk is not None and talk.takes(understood):
                proposed = talk.settled(understood)
                if isinstance(proposed, Failure) or proposed.parsed.question is not None:
                    return proposed
                understood = proposed
            one = settled(understood, attendant, "ask", self._note, self._now_s, session.interruption)
            if isinstance(said, Script):  # a long one must not keep the heartbeat waiting
                session.hold(_IDLE_S)
                self._desk.poll()
            return one

        with session.request() as request:
            arriving = statements_of(said, self._conversation, self._trust)
            statements, instead = settle_all(
                arriving, settle, self._note, self._now_s, lambda: request.taken(self._now_s(), self._note)
            )
            again = None if talk is None else talk.again
            results = instead or run_statements(statements, session, attendant, "ask", self._note, again)
            self._failed = failed_command(results)
            return results

    def _by_hand(self) -> list[Said]:
        """Let a person carry on with the task that failed last, or just jog the robot."""
        self._steps.busy = True
        command, self._failed = self._failed or ByHandTask(BY_HAND), None
        result = driven(self._session.task_steps(command, by_hand=True))
        return [(Statement(Parsed(command.text, (command,))), [result])]

    def _follow(self, said: FollowTrajectory) -> list[Said]:
        """Move as a program has planned, where the checker agrees."""
        name = name_of(said)
        try:
            task = FollowTrajectoryTask(name, load_joint_motion(Path(said.path)))
        except TrajectoryFileError as wrong:
            refused = TaskResult(name, FollowTrajectoryTask.action, "refused")
            return [(Statement(Parsed(name, refusal=Refusal(str(wrong)))), [refused])]
        self._steps.busy = True
        result = driven(self._session.task_steps(task))
        return [(Statement(Parsed(name, (task,))), [result])]

    def _now_s(self) -> float:
        return self._link.now_s

    # ---------------------------------------------------------------- on the way

    def _meanwhile(self) -> None:
        self._desk.poll()
        engaged = self._link.emergency is not None
        if engaged and not self._engaged:
            self._supervisor.stopped()
        elif self._engaged and not engaged:
            self._supervisor.reset("a person")
        self._engaged = engaged

    def cancel(self, reason: str) -> None:
        """Halt what is under way, and hold."""
        self._session.cancel(reason)

    def pause(self, reason: str) -> None:
        """Hold what is under way where it is."""
        self._session.pause(reason)

    def resume(self) -> None:
        """Go on with it."""
        self._session.resume()

    def _note(self, event: Event) -> None:
        self._desk.watchers.event(event)
        if self._account is not None:
            self._account.hear(event)

    def _show(self, tree: TaskTree) -> None:
        self._tree = tree
        self._desk.trees.note(tree)
        self._tell_tree()
        if self._display is not None:
            self._display.tick(tree)

    def _tell_tree(self, last: bool = False) -> None:
        """Let those who watch see the tree as it stands."""
        if (tree := self._tree) is not None:
            now_s = self._link.now_s
            self._desk.watchers.tree(lambda: tree.snapshot(now_s), now_s, last, self._desk.trees.number)


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


def _is_stop(text: str) -> bool:
    commands = parse(text).commands
    return len(commands) == 1 and isinstance(commands[0], StopCommand)
