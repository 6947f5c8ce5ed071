"""Several commands in order: references, several objects, questions, and nothing half done."""

from dataclasses import replace

import pytest

from executive.dialogue import settle_words
from executive.dialogue.clarification import OpenQuestion
from executive.errands.errand import Errand
from executive.meaning import StopCommand
from executive.session.driver import driven
from executive.session.events import InputTaken, QuestionAsked, TaskAccepted
from executive.understanding.command_parser import parse
from executive.understanding.provenance import Provenance
from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball, Box, Cylinder
from robots.fake.fake_world import bowl, cup, person
from robots.perception.truth_view import TrueObject
from robots.scenes.scene_description import Region
from trees.events import NodeChanged, ThingPictured
from trees.tasks import (
    DescribeTask,
    FindTask,
    GoHomeTask,
    HandOverTask,
    LookAtTask,
    ObjectDescription,
    ObjectOf,
    OpenTask,
    PickTask,
    PlaceTask,
    PointAtTask,
    PutInTask,
    Relation,
    WalkToTask,
    WaveTask,
)

A_CUP = PickTask("pick up the cup", ObjectDescription("cup"))
RED_CUP = PickTask("pick up the red cup", ObjectDescription("cup", "red"))
LEFT, RIGHT = cup("a", "red", (0.45, 0.2)), cup("b", "blue", (0.45, -0.2))
CAN = TrueObject(
    "green can", "object", "can", "green", Cylinder(0.03, 0.1), poses.translation(0.5, 0.0, 0.95)
)
BALL = TrueObject("blue ball", "object", "ball", "blue", Ball(0.03), poses.translation(0.5, -0.15, 0.93))
GUEST = ObjectDescription("guest")
SHELF = TrueObject(
    "shelf", "furniture", "shelf", None, Box((0.3, 0.5, 0.03)), poses.translation(0.6, 0.6, 1.1)
)


class Stage:
    """A session with a fake robot, and somebody who answers."""

    def __init__(self, fake):
        self.fake, self.of, self.arms_moved = fake, fake.of, fake.arms_moved
        self.moved_when_asked = []

    def run(self, *commands, answers=(), **options):
        self.questions, self.answers = [], list(answers)
        session = self.fake.session
        return driven(Errand(session, commands, **options).steps(), self.answer)

    def holds_something(self):
        return any(gripper.reading().holding for gripper in self.fake.fake.grippers.values())

    def answer(self, question):
        self.moved_when_asked.append(self.arms_moved() or self.holds_something())
        self.questions.append(question)
        return self.answers.pop(0) if self.answers else None


@pytest.fixture
def stage(fake_stage):
    return lambda *things: Stage(fake_stage(*things))


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


@pytest.mark.requirement("L6", "F1")
@pytest.mark.parametrize(("answer", "outcome"), [("yes", "done"), ("no", "cancelled"), (None, "question")])
def test_the_only_one_is_asked_about_where_it_may_not_be_what_was_said(stage, answer, outcome):
    on = stage(LEFT)
    wooden = PickTask("take the wooden cup", ObjectDescription("cup", material="wood"))

    [result] = on.run(wooden, answers=[answer])

    assert on.questions == [
        OpenQuestion("which one is made of wood? that cannot be seen", ("red cup",)),
    ]
    assert result.outcome == outcome
    assert on.moved_when_asked == [False]


@pytest.mark.requirement("P2")
@pytest.mark.parametrize(("answer", "outcome"), [("yes", "done"), ("no", "cancelled"), (None, "question")])
def test_what_the_camera_is_not_sure_of_is_asked_about_and_the_answer_is_heeded(stage, answer, outcome):
    on = stage(LEFT)
    on.fake.fake.detector.confidence[LEFT.name] = 0.3

    [result] = on.run(PickTask("take the red cup", ObjectDescription("cup", "red")), answers=[answer])

    assert on.questions == [OpenQuestion("is this the red cup?", ("red cup",))]
    assert [event.what for event in on.of(ThingPictured)] == ["red cup"]
    assert result.outcome == outcome
    assert on.moved_when_asked == [False]


def test_who_is_alone_there_is_the_guest(stage):
    on = stage(person())

    [result] = on.run(WaveTask("wave to the guest", GUEST))

    assert result.outcome == "done"
    assert on.questions == []


def test_an_answer_may_describe_what_the_choices_do_not_say(stage):
    on = stage(LEFT, RIGHT)

    [result] = on.run(A_CUP, answers=["the purple one", "2"])

    assert on.questions[1].tried == "'the purple one' is none of the choices"
    assert result.acted_on == "blue cup"


@pytest.mark.parametrize(
    ("answer", "name"),
    [("the leftmost one", "red cup"), ("the rightmost", "blue cup"), ("nearest", "red cup")],
)
def test_an_answer_may_compare_the_choices(stage, answer, name):
    on = stage(cup("a", "red", (0.45, 0.1)), RIGHT)

    [result] = on.run(A_CUP, answers=[answer])

    assert len(on.questions) == 1
    assert result.acted_on == name


def test_a_withdrawn_task_is_cancelled_and_nothing_after_it_begins(stage):
    on = stage(LEFT, RIGHT)

    results = on.run(A_CUP, GoHomeTask("go home"), answers=["never mind"])

    assert [result.outcome for result in results] == ["cancelled"]
    assert results[0].failure.message == "withdrawn by the answer"


@pytest.mark.requirement("S7", "S4")
@pytest.mark.parametrize("what", ["cancel", "emergency_stop"])
def test_a_cancel_or_a_stop_while_a_question_is_open_ends_the_errand_whatever_is_answered(fake_stage, what):
    on = Stage(fake_stage(LEFT, RIGHT, guarded=True))
    end = getattr(on.fake.session, what)
    on.answer = lambda _question: end("enough") or "the blue one"

    results = on.run(A_CUP, GoHomeTask("go home"))

    assert [result.outcome for result in results] == ["cancelled"]
    assert "enough" in results[0].failure.message
    assert not on.arms_moved()


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

    monkeypatch.setattr(settle_words, "has_skill", lambda task: not isinstance(task, OpenTask))
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


@pytest.mark.requirement("L6")
@pytest.mark.parametrize(
    ("task", "slot"),
    [
        (PointAtTask("point at the cup", ObjectDescription("cup")), "object"),
        (LookAtTask("look at the cup", ObjectDescription("cup")), "object"),
        (DescribeTask("describe the cup", ObjectDescription("cup")), "object"),
        (FindTask("where is the cup", ObjectDescription("cup")), "object"),
    ],
)
def test_whatever_is_asked_which_is_meant_goes_on_with_the_answer(stage, task, slot):
    on = stage(LEFT, RIGHT)

    [result] = on.run(task, answers=["the blue one"])

    assert [question.text for question in on.questions] == ["which cup? there are 2"]
    assert result.outcome == "done"


@pytest.mark.requirement("L6")
def test_an_answer_may_be_about_what_something_is_put_beside(stage):
    on = stage(LEFT, RIGHT, cup("c", "green", (0.5, 0.0)))
    beside = ObjectDescription(relation=Relation("next_to", ObjectDescription("cup")))
    red = ObjectDescription("cup", "red")

    [_, result] = on.run(
        PickTask("take the red cup", red), PlaceTask("put it next to the cup", red, to=beside), answers=["2"]
    )

    assert on.questions[0].choices == ("green cup", "blue cup")
    assert result.outcome == "done"


@pytest.mark.requirement("L3")
@pytest.mark.parametrize(("ordinal", "choices"), [("leftmost", ()), (None, ("Ben", "Ana"))])
def test_the_person_on_the_left_is_waved_at_and_the_guest_asked_about(stage, ordinal, choices):
    on = stage(person("Ana", (1.5, -0.6)), person("Ben", (1.5, 0.6)))
    wanted = ObjectDescription("person" if ordinal else "guest", ordinal=ordinal)

    [result] = on.run(WaveTask("wave", wanted), answers=["the left one"])

    assert [question.choices for question in on.questions] == ([choices] if choices else [])
    assert result.outcome == "done"
    located = [
        event.message for event in on.of(NodeChanged) if event.message.startswith(("Ana at", "Ben at"))
    ]
    assert located[-1].split()[0] == "Ben"


@pytest.mark.requirement("L3")
@pytest.mark.parametrize("count", ["both", "all", 2])
def test_each_of_several_things_is_put_down_in_turn(stage, count):
    on = stage(LEFT, RIGHT, CAN)
    beside = ObjectDescription(relation=Relation("next_to", ObjectDescription("can")))

    results = on.run(PlaceTask("put the cups there", ObjectDescription("cup"), to=beside, count=count))

    assert [one.outcome for one in results] == ["done", "done"]
    assert sorted(one.evidence["object"] for one in results) == ["blue cup", "red cup"]


def test_everything_does_not_mean_what_it_is_put_next_to(stage):
    on = stage(LEFT, RIGHT, CAN)
    beside = ObjectDescription(relation=Relation("next_to", ObjectDescription("can")))

    results = on.run(PlaceTask("put everything there", ObjectDescription(), to=beside, count="all"))

    assert sorted(one.evidence["object"] for one in results) == ["blue cup", "red cup"]


def test_of_several_things_none_is_in_a_hand_already(stage):
    on = stage(LEFT, RIGHT)
    on.run(PickTask("take the red cup", ObjectDescription("cup", "red")))

    [result] = on.run(PlaceTask("put both cups down", ObjectDescription("cup"), count="both"))

    assert result.outcome == "failed"
    assert "the red cup is in the hand already" in result.failure.message


@pytest.mark.requirement("F1")
@pytest.mark.parametrize(
    ("rooms", "told"),
    [
        ((), "there is no kitchen on the map; it has no rooms"),
        (("hall", "bedroom"), "there is no kitchen on the map; it has the bedroom and the hall"),
    ],
)
@pytest.mark.parametrize(
    "task", [WalkToTask("go", "kitchen"), DescribeTask("what is there", source="kitchen")]
)
def test_a_room_that_is_not_on_the_map_is_told_before_anything_moves(fake_stage, rooms, told, task):
    places = {name: Region(name, (0.0, 0.0), (4.0, 4.0)) for name in rooms}
    on = Stage(fake_stage(LEFT, places=places))

    [result] = on.run(task)

    assert (result.outcome, result.failure.message) == ("failed", told)
    assert on.fake.session.now_s == 0.0


def test_what_the_robot_lacks_for_a_skill_is_told_before_anything_moves(fake_stage):
    on = Stage(fake_stage(LEFT))

    [result] = on.run(WalkToTask("go", ObjectDescription("table")))

    assert (result.outcome, result.failure.message) == (
        "failed",
        "walk_to needs feet; talos cannot walk here",
    )
    assert on.fake.session.now_s == 0.0


TOO_LOW = "the floor is too low for the hands of this robot"


@pytest.mark.parametrize(
    ("sentence", "told"),
    [
        ("put the cup on the floor", TOO_LOW),
        ("pick up the ball from the floor", TOO_LOW),
        ("pick up the ball on the ground", TOO_LOW),
        ("pick up the cup and put it on the floor", TOO_LOW),
        ("put the cup under the table", "this robot puts nothing below something else, as under the table"),
    ],
)
def test_what_no_search_would_help_with_is_not_looked_for_and_nothing_is_half_done(
    fake_stage, sentence, told
):
    on = Stage(fake_stage(LEFT))

    [result] = on.run(*parse(sentence).commands)

    assert (result.outcome, result.failure.message) == ("failed", told)
    assert on.fake.session.now_s == 0.0


def test_a_room_that_is_also_furniture_may_be_looked_for(stage):
    [result] = stage(LEFT).run(DescribeTask("what is on it", source="table"))

    assert result.outcome == "done"


@pytest.mark.requirement("L3")
def test_the_other_one_is_not_the_one_in_the_hand(stage):
    on = stage(LEFT, RIGHT)
    other = ObjectDescription(relation=Relation("next_to", ObjectDescription("cup", ordinal="other")))

    [result] = on.run(
        PlaceTask("put the red cup next to the other one", ObjectDescription("cup", "red"), to=other)
    )

    assert result.outcome == "done"


@pytest.mark.requirement("L6")
@pytest.mark.parametrize(
    ("task", "choices"),
    [
        (
            PlaceTask(
                "put the can next to the cup",
                ObjectDescription("can"),
                to=ObjectDescription(relation=Relation("next_to", ObjectDescription("cup"))),
            ),
            ("red cup", "blue cup"),
        ),
        (
            PutInTask("put the can in the bowl", ObjectDescription("can"), "bowl"),
            ("left white bowl", "right white bowl"),
        ),
        (HandOverTask("give the can to a guest", ObjectDescription("can"), GUEST), ("Ben", "Ana")),
    ],
)
def test_where_it_goes_is_asked_before_it_is_picked_up(stage, task, choices):
    people = person("Ana", (1.5, -0.6)), person("Ben", (1.5, 0.6))
    bowls = [replace(bowl((0.65, y_m)), name=f"bowl at {y_m}") for y_m in (0.4, -0.4)]
    on = stage(LEFT, RIGHT, CAN, *bowls, *people)

    [result] = on.run(task, answers=["2"])

    assert [question.choices for question in on.questions] == [choices]
    assert on.moved_when_asked == [False]
    assert result.outcome == "done" or "nobody took" in result.failure.message


@pytest.mark.parametrize(
    ("task", "told"),
    [
        (
            PlaceTask("put it on the ball", ObjectDescription("cup"), on=ObjectDescription("ball")),
            "nothing stands on a blue ball: it is round",
        ),
        (
            PlaceTask(
                "put it next to the lamp",
                ObjectDescription("cup"),
                to=ObjectDescription(relation=Relation("next_to", ObjectDescription("lamp"))),
            ),
            "no lamp seen",
        ),
        (
            PutInTask("put it in the can", ObjectDescription("cup"), ObjectDescription("can")),
            "the red cup is too wide for the green can",
        ),
        (HandOverTask("give it to Zoe", ObjectDescription("cup"), "Zoe"), "no Zoe seen"),
    ],
)
def test_what_has_nowhere_to_go_is_not_picked_up(stage, task, told):
    on = stage(LEFT, CAN, BALL)

    [result] = on.run(task)

    assert told in result.failure.message
    assert not on.arms_moved()
    assert not on.holds_something()


@pytest.mark.parametrize(("more", "asked"), [((), []), ((SHELF,), [("the table", "the shelf")])])
def test_on_what_in_a_room_a_thing_is_put_is_asked_where_there_is_a_choice(fake_stage, more, asked):
    kitchen = Region("kitchen", (0.0, 0.0), (4.0, 4.0))
    on = Stage(fake_stage(LEFT, *more, places={"kitchen": kitchen}))

    [result] = on.run(
        PlaceTask("bring the cup to the kitchen", ObjectDescription("cup"), to="kitchen"), answers=["table"]
    )

    assert [question.choices for question in on.questions] == asked
    assert result.outcome == "done"
    assert result.evidence["on"] == "table"
