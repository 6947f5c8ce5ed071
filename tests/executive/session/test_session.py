"""A session runs commands to their end, whatever they do, and leaves a robot that holds."""

import numpy as np
import pytest

from executive.exit_codes import ExitCode
from executive.meaning import StopCommand
from executive.session import session as session_module
from executive.session.driver import driven
from executive.session.events import InputTaken, SensorsNoted, TaskAccepted, TaskEnded
from executive.session.lockstep import PERIODS_A_TICK, SETTLE_TICKS
from executive.session.planning_jobs import PlanningJobs
from executive.session.session import HALT_TICKS, TASK_TIMEOUT_S, Session
from robots.clock import ManualClock
from robots.interface.robot import RobotState
from robots.interface.sensed_state import SensedState
from trees.failures import Failure, FailureKind
from trees.policy import TreePolicy
from trees.tasks import GoHomeTask, ObjectDescription, PickTask, Relation, WaitTask
from trees.toolbox import Pauses

HOME = GoHomeTask("go home")


class Loop:
    def __init__(self, clock):
        self.clock, self.steps = clock, 0

    @property
    def sensing(self):
        return self

    def state(self):
        ones = np.full(3, float(self.steps))
        readings = RobotState(self.clock.now_s(), ones, ones, ones, ones, ones, ones)
        return SensedState(readings, lambda: ones)

    def step(self):
        self.steps += 1
        self.clock.advance(0.002)


class Toolbox:
    def __init__(self, clock):
        self.clock, self.walking, self.pauses = clock, None, Pauses()


class Tree:
    """Ends after some ticks, or never."""

    def __init__(self, ticks=None, failure=None):
        self.ticks, self.end, self._failure = 0, ticks, failure
        self.status, self.failure, self.evidence, self.attempts, self.halted = "running", None, {}, 1, None
        self.acted_on, self.others = None, ()

    def tick(self):
        self.ticks += 1
        if self.end is not None and self.ticks >= self.end:
            self.failure = self._failure
            self.status = "failure" if self.failure else "success"
            self.evidence = {} if self.failure else {"opening_m": 0.06}

    def halt(self, reason):
        self.halted, self.status = reason, "failure"
        self.failure = Failure(FailureKind.CANCELED, reason)


class Stage:
    def __init__(self, monkeypatch, tree, **hooks):
        self.clock, self.events, self.tree = ManualClock(), [], tree
        self.loop = Loop(self.clock)
        monkeypatch.setattr(session_module, "build_tree", lambda task, toolbox: tree)
        planning = PlanningJobs(None, None, self.clock, self.events.append)
        self.session = Session(Toolbox(self.clock), self.loop, planning, self.events.append, **hooks)


@pytest.fixture
def stage(monkeypatch):
    return lambda tree, **hooks: Stage(monkeypatch, tree, **hooks)


def test_a_task_that_succeeds_is_done_with_its_evidence(stage):
    on = stage(Tree(ticks=5))

    result = on.session.run_task(HOME)

    assert result.outcome == "done"
    assert result.evidence == {"opening_m": 0.06}
    assert result.times.simulated_s == pytest.approx(4 * 0.02)


@pytest.mark.parametrize(
    ("wanted", "subject"),
    [
        (ObjectDescription(), "blue box"),
        (ObjectDescription("cup", "red"), "red cup"),
        (ObjectDescription(relation=Relation("left_of", "table")), "blue box"),
    ],
)
def test_a_thing_that_was_not_named_is_called_what_it_came_to_be(stage, wanted, subject):
    tree = Tree(ticks=5)
    tree.acted_on = "blue box 2"

    assert stage(tree).session.run_task(PickTask("pick it up", wanted)).subject == subject


def test_the_tree_ticks_every_20_ms_after_the_robot_has_settled(stage):
    on = stage(Tree(ticks=5))

    on.session.run_task(HOME)

    assert on.tree.ticks == 5
    assert on.loop.steps == (SETTLE_TICKS + 4) * PERIODS_A_TICK


def test_a_failed_task_carries_its_failure(stage):
    failure = Failure.infeasible("no grasp")

    result = stage(Tree(2, failure)).session.run_task(HOME)

    assert (result.outcome, result.failure) == ("failed", failure)


@pytest.mark.requirement("S9")
def test_every_task_is_told_at_its_beginning_and_end(stage):
    on = stage(Tree(2))

    on.session.run_task(HOME)

    assert isinstance(on.events[0], TaskAccepted)
    assert isinstance(on.events[-1], TaskEnded)
    assert on.events[-1].outcome == "done"


def test_a_cancelled_task_halts_its_tree_and_goes_on_until_it_has_braked(stage):
    on = stage(
        Tree(), on_tick=lambda tree: tree.ticks == 3 and not tree.halted and on.session.cancel("by the user")
    )

    result = on.session.run_task(HOME)

    assert result.outcome == "cancelled"
    assert result.failure.kind is FailureKind.CANCELED
    assert on.tree.halted == "by the user"
    assert on.loop.steps >= HALT_TICKS * PERIODS_A_TICK


def test_the_session_is_usable_after_a_cancel(stage, monkeypatch):
    on = stage(
        Tree(),
        on_tick=lambda tree: tree.halted is None and tree.end is None and on.session.cancel("by the user"),
    )
    on.session.run_task(HOME)
    monkeypatch.setattr(session_module, "build_tree", lambda task, toolbox: Tree(2))

    assert on.session.run_task(HOME).outcome == "done"


@pytest.mark.requirement("S7")
def test_a_cancel_while_nothing_is_under_way_has_nothing_to_halt(stage):
    made = stage(Tree(ticks=3))
    made.session.cancel("too early")

    assert made.session.run_task(HOME).outcome == "done"


@pytest.mark.requirement("S7")
def test_a_cancel_between_two_tasks_of_a_request_halts_the_second(stage):
    made = stage(Tree(ticks=3))
    with made.session.request():
        first = made.session.run_task(HOME)
        made.session.cancel("in between")
        made.session.hold(0.1)
        second = made.session.run_task(HOME)

    assert (first.outcome, second.outcome) == ("done", "cancelled")
    assert made.session.run_task(HOME).outcome == "done"


def test_a_task_that_never_ends_is_given_up(stage):
    on = stage(Tree())

    result = on.session.run_task(HOME, timeout_s=1.0)

    assert result.outcome == "failed"
    assert result.failure.kind is FailureKind.TIMEOUT
    assert result.exit_code is ExitCode.FAILED
    assert on.tree.halted


def test_a_spoken_stop_builds_no_tree(stage):
    on = stage(Tree())

    result = on.session.run_task(StopCommand("stop"))

    assert result.outcome == "done"
    assert on.tree.ticks == 0


def test_sensors_and_monitors_are_called_each_control_period(stage):
    calls = []
    on = stage(
        Tree(3), tick_sensors=lambda: calls.append("sensors"), on_period=lambda: calls.append("monitor")
    )

    on.session.run_task(HOME)

    assert calls == ["sensors", "monitor"] * on.loop.steps


def test_equal_runs_note_equal_sensors(stage):
    noted = []
    for _ in range(2):
        on = stage(Tree(60))
        on.session.run_task(HOME)
        noted.append([event for event in on.events if isinstance(event, SensorsNoted)])

    assert noted[0] == noted[1]
    assert len({event.sha256 for event in noted[0]}) == len(noted[0]) >= 2


def test_a_cancel_is_noted_as_an_input_with_its_instant(stage):
    on = stage(
        Tree(), on_tick=lambda tree: tree.ticks == 3 and not tree.halted and on.session.cancel("enough")
    )

    on.session.run_task(HOME)

    [taken] = [event for event in on.events if isinstance(event, InputTaken)]
    assert (taken.what, taken.value) == ("cancel", "enough")
    assert taken.t_s == pytest.approx(0.2 + 3 * 0.02)


def test_a_task_can_be_let_go_on_a_tick_at_a_time(stage):
    on = stage(Tree(3))
    steps = on.session.task_steps(HOME)

    next(steps)
    before = on.loop.steps
    next(steps)

    assert on.loop.steps == before + PERIODS_A_TICK
    assert driven(steps).outcome == "done"


class Held:
    """Notes when the robot is to be held."""

    def __init__(self):
        self.told = []

    def pause(self, reason):
        self.told.append(("pause", reason))

    def resume(self):
        self.told.append(("resume",))


def test_a_paused_task_is_not_ticked_until_it_goes_on_and_its_time_does_not_count(stage):
    held, tree = Held(), Tree(ticks=20)
    made = stage(tree, pausing=held)
    steps = made.session.task_steps(HOME, timeout_s=1.0)
    for _ in range(5):
        next(steps)
    ticked = tree.ticks
    made.session.pause("by the test")
    for _ in range(200):  # four seconds, far longer than the task may take
        next(steps)

    assert tree.ticks == ticked
    assert made.session.paused
    assert held.told == [("pause", "by the test")]

    made.session.resume()
    result = driven(steps)

    assert result.outcome == "done"
    assert held.told[1:] == [("resume",)]
    inputs = [(event.what, event.value) for event in made.events if isinstance(event, InputTaken)]
    assert inputs == [("pause", "by the test"), ("resume", "")]


@pytest.mark.requirement("S7")
def test_a_paused_task_can_be_cancelled_and_the_pause_ends_with_it(stage):
    held = Held()
    made = stage(Tree(), pausing=held)
    steps = made.session.task_steps(HOME)
    next(steps)
    made.session.pause("by the test")
    for _ in range(3):
        next(steps)
    made.session.cancel("enough")

    assert driven(steps).outcome == "cancelled"
    assert not made.session.paused
    assert held.told[-1] == ("resume",)


def test_a_pause_while_nothing_is_under_way_is_forgotten(stage):
    made = stage(Tree(ticks=3), pausing=Held())
    made.session.pause("by the test")
    made.session.hold(0.1)

    assert made.session.run_task(HOME).outcome == "done"


def test_every_tree_gives_up_tidily_before_the_session_cuts_it_off():
    policy = TreePolicy()

    longest_s = policy.task_timeout_s + policy.walk_timeout_s  # what is put behind a door
    assert longest_s + 30.0 < TASK_TIMEOUT_S


def test_a_wait_may_last_longer_than_what_a_task_does_is_given(fake_stage):
    on = fake_stage()

    result = on.session.run_task(WaitTask("wait", TASK_TIMEOUT_S + 60.0))

    assert (result.outcome, result.failure) == ("done", None)


def test_a_wait_is_given_up_when_a_limit_of_its_own_says_so(fake_stage):
    on = fake_stage()

    result = on.session.run_task(WaitTask("wait", 30.0), timeout_s=5.0)

    assert result.outcome == "failed"
