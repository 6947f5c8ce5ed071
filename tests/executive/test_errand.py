"""Several commands in order: references, several objects, questions, and nothing half done."""

import numpy as np
import pytest
from py_trees.blackboard import Blackboard

from executive.clarification import OpenQuestion
from executive.errand import Errand, drive
from executive.events import InputTaken, QuestionAsked, TaskAccepted
from executive.meaning import StopCommand
from executive.planning_jobs import PlanningJobs
from executive.session import Session
from executive.task_result import Provenance
from kinematics.robot_model import RobotModel
from kinematics.trajectory import CheckedTrajectory
from robots.description import load_description
from robots.fake.fake_world import FakeWorld, cup, table
from trees.policy import TreePolicy
from trees.tasks import GoHomeTask, ObjectDescription, ObjectOf, OpenTask, PickTask
from trees.toolbox import Toolbox
from trees.world_model import WorldModel

QUICK = TreePolicy(look_frames=2, look_timeout_s=0.4, hold_s=0.2, grasp_settle_s=0.04, motion_slack_s=0.2)
A_CUP = PickTask("pick up the cup", ObjectDescription("cup"))
RED_CUP = PickTask("pick up the red cup", ObjectDescription("cup", "red"))


def believed(request):
    checked = object.__new__(CheckedTrajectory)
    for name, value in {
        "trajectory": request.trajectory, "scene_version": request.scene.version, "min_distance_m": 0.02,
        "min_com_margin_m": 0.03, "seal": None,
    }.items():  # fmt: skip
        object.__setattr__(checked, name, value)
    return checked


class Loop:
    """Steps the fake robot once every ten control periods."""

    def __init__(self, fake):
        self.fake, self.sensing, self.count = fake, fake.sensing, 0

    def step(self):
        self.count += 1
        if self.count % 10 == 0:
            self.fake.step()


class Stage:
    def __init__(self, model, *things):
        self.fake, self.events = FakeWorld(model, believed, [table(), *things]), []
        toolbox = Toolbox(
            clock=self.fake.clock, model=model, motion=self.fake.motion, sensing=self.fake.sensing,
            grippers=self.fake.grippers, detector=self.fake.detector, planning=self.fake.planning,
            world=WorldModel(), events=self.events.append, rng=np.random.default_rng(1), policy=QUICK,
        )  # fmt: skip
        planning = PlanningJobs(None, self.fake.clock, self.events.append)
        self.session = Session(toolbox, Loop(self.fake), planning, self.events.append)
        self.moved_when_asked = []

    def run(self, *commands, answers=(), **options):
        left = list(answers)

        def ask(question):
            self.moved_when_asked.append(self.arms_moved())
            self.questions.append(question)
            return left.pop(0) if left else None

        self.questions = []
        return drive(Errand(self.session, commands, **options).steps(), ask)

    def arms_moved(self):
        model, q = self.fake.model, self.fake.motion.reference()[7:]
        arms = [i for i, name in enumerate(model.joints) if name.startswith("arm_")]
        return len(arms) == 14 and bool(np.abs(q - model.q_home[7:])[arms].max() > 1e-6)

    def of(self, kind):
        return [event for event in self.events if isinstance(event, kind)]


@pytest.fixture(scope="module")
def model():
    return RobotModel(load_description("talos"))


@pytest.fixture
def stage(model):
    yield lambda *things: Stage(model, *things)
    Blackboard.clear()


LEFT, RIGHT = cup("a", "red", (0.45, 0.2)), cup("b", "blue", (0.45, -0.2))


@pytest.mark.requirement("L6")
def test_the_answer_continues_the_same_task_with_the_object_that_was_chosen(stage):
    on = stage(LEFT, RIGHT)

    [result] = on.run(A_CUP, answers=["the blue one"])

    assert on.questions == [OpenQuestion("which cup? there are 2", ("red cup", "blue cup"))]
    assert result.outcome == "done"
    assert result.acted_on == "blue cup"
    assert result.subject == "blue cup"


@pytest.mark.requirement("L6")
def test_nothing_is_reached_for_before_the_answer(stage):
    on = stage(LEFT, RIGHT)

    [result] = on.run(A_CUP)

    assert on.moved_when_asked == [False]
    assert not on.arms_moved()
    assert result.outcome == "question"
    assert on.of(InputTaken)[-1].value == ""


def test_an_answer_may_describe_what_the_choices_do_not_say(stage):
    on = stage(LEFT, RIGHT)

    [result] = on.run(A_CUP, answers=["the purple one", "2"])

    assert on.questions[1].tried == "'the purple one' is none of the choices"
    assert result.acted_on == "blue cup"


def test_a_withdrawn_task_is_cancelled_and_nothing_after_it_begins(stage):
    on = stage(LEFT, RIGHT)

    results = on.run(A_CUP, GoHomeTask("go home"), answers=["never mind"])

    assert [result.outcome for result in results] == ["cancelled"]
    assert results[0].failure.message == "withdrawn by the answer"


@pytest.mark.parametrize(("policy", "outcome"), [("first", "done"), ("fail", "question")])
def test_questions_can_be_settled_beforehand(stage, policy, outcome):
    on = stage(LEFT, RIGHT)

    [result] = on.run(A_CUP, on_question=policy)

    assert not on.questions
    assert result.outcome == outcome
    assert len(on.of(QuestionAsked)) == 1


@pytest.mark.requirement("L2")
def test_it_is_what_the_task_before_was_about(stage):
    on = stage(LEFT, RIGHT)
    again = PickTask("pick it up", ObjectOf(0), hand="right")

    on.run(PickTask("pick up the blue cup", ObjectDescription("cup", "blue")), again)

    second = on.of(TaskAccepted)[1].meaning
    assert second["object"] == {"kind": "cup", "color": "blue", "name": "blue cup"}


def test_a_reference_to_nothing_fails_without_motion(stage):
    on = stage(LEFT)

    results = on.run(GoHomeTask("go home"), PickTask("pick it up", ObjectOf(0)))

    assert results[-1].outcome == "failed"
    assert results[-1].failure.message == "what 'pick it up' refers to is not known"


def test_both_are_picked_one_after_the_other(stage):
    on = stage(LEFT, RIGHT)

    results = on.run(PickTask("pick up both cups", ObjectDescription("cup"), count="both"))

    assert [result.acted_on for result in results] == ["blue cup", "red cup"]
    assert [result.outcome for result in results] == ["done", "done"], results[-1].failure


@pytest.mark.requirement("L5")
def test_nothing_begins_when_a_later_command_is_no_skill(stage, monkeypatch):
    from executive import errand

    monkeypatch.setattr(errand, "has_skill", lambda task: not isinstance(task, OpenTask))
    on = stage(LEFT)

    results = on.run(RED_CUP, OpenTask("open the fridge", ObjectDescription("fridge")))

    assert [result.outcome for result in results] == ["refused"]
    assert "no skill of this robot yet" in results[0].failure.message
    assert not on.of(TaskAccepted)


def test_a_stop_among_the_commands_needs_no_skill(stage):
    on = stage(LEFT)

    assert [result.outcome for result in on.run(StopCommand("stop"))] == ["done"]


@pytest.mark.requirement("L7")
def test_provenance_is_kept_with_each_task(stage):
    on = stage(LEFT)
    step = Provenance(0, 0.93, "sentence")

    [result] = on.run(RED_CUP, provenance=[step])

    assert result.provenance == step
    assert result.to_json()["provenance"] == {"step": 0, "confidence": 0.93, "form": "sentence"}
