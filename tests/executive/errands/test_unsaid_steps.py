"""What has to be done before a command, that nobody said."""

from contextlib import nullcontext
from dataclasses import replace
from types import SimpleNamespace

import pytest

from executive.errands.errand import Errand
from executive.errands.prepared import Known
from executive.errands.required import with_names
from executive.errands.unsaid_steps import prepared
from executive.session.driver import driven
from executive.session.task_result import TaskResult, TaskTimes
from executive.understanding.command_parser import parse
from robots.models.description import load_description
from trees.failures import Failure, Reason
from trees.skills.greet import GreetTask
from trees.tasks import (
    WHERE_IT_WAS,
    CloseTask,
    CountTask,
    FindTask,
    HandOverTask,
    MoveTask,
    ObjectDescription,
    ObjectOf,
    OpenTask,
    PickTask,
    PlaceTask,
    PutInTask,
    WalkToTask,
)


def steps(sentence, can_walk=True):
    return prepared(parse(sentence).commands, can_walk)


def kinds(sentence):
    return [type(step.command) for step in steps(sentence)]


@pytest.mark.requirement("L2")
def test_bringing_something_out_of_the_fridge_means_going_there_opening_it_and_coming_back():
    assert kinds("bring me the bottle from the fridge") == [
        FindTask, WalkToTask, OpenTask, WalkToTask, PickTask, WalkToTask, HandOverTask,
    ]  # fmt: skip


def test_what_was_said_keeps_its_number():
    assert [step.said for step in steps("bring me the bottle from the fridge")] == [
        None, None, None, None, 0, None, 1,
    ]  # fmt: skip


def test_who_speaks_is_found_out_before_the_robot_goes_away():
    first = steps("bring me the bottle from the fridge")[0]

    assert first.finds_who == "me"
    assert first.command.person == "me"


@pytest.mark.requirement("L2")
@pytest.mark.parametrize(
    "sentence",
    ["walk to Ana and come back", "move forward 2 meters and come back", "open the fridge, come to me"],
)
def test_who_speaks_is_known_before_the_robot_is_sent_away_and_told_to_come_back(sentence):
    first = steps(sentence)[0]

    assert first.finds_who == "me"
    assert first.may_fail


def test_who_is_in_front_is_found_out_before_the_robot_goes_away_by_itself():
    first = steps("take the bottle from the fridge and give it to the person in front of you")[0]

    assert (first.finds_who, first.command.person, first.may_fail) == ("in_front", "in_front", False)


def test_who_is_in_front_where_the_robot_was_sent_is_found_out_there():
    said = steps("walk to the kitchen, take the bottle and give it to the person in front of you")

    assert not any(step.finds_who for step in said)


@pytest.mark.parametrize(
    "sentence", ["come here", "wave to Ana and come here", "come here, then walk to Ana"]
)
def test_who_speaks_is_walked_to_at_once_where_the_robot_has_not_been_sent_away(sentence):
    assert FindTask not in kinds(sentence)


def test_who_is_to_be_given_something_has_to_be_there():
    assert not steps("bring me the bottle from the fridge")[0].may_fail


def test_somebody_who_is_named_need_not_be_looked_for_first():
    assert FindTask not in kinds("bring Ana the bottle from the fridge")


def test_a_fridge_that_is_opened_by_the_same_sentence_is_opened_once():
    assert kinds("open the fridge and bring Ana the bottle from the fridge").count(OpenTask) == 1


def test_a_walk_that_was_said_is_not_walked_twice():
    said = "take the bottle from the fridge, walk to Ana and give it to her"

    assert [step.command.to for step in steps(said) if type(step.command) is WalkToTask][-1] == "Ana"
    assert kinds(said)[-3:] == [PickTask, WalkToTask, HandOverTask]


@pytest.mark.parametrize(
    "sentence",
    ["bring me the red cup from the table", "pick up the cup", "walk to the kitchen and open the fridge"],
)
def test_what_is_at_hand_is_done_as_it_was_said(sentence):
    commands = parse(sentence).commands

    assert tuple(step.command for step in steps(sentence)) == commands


def test_a_robot_that_cannot_walk_does_what_was_said_from_where_it_stands():
    said = steps("bring me the bottle from the fridge", can_walk=False)

    assert [type(step.command) for step in said] == [PickTask, HandOverTask]


def test_me_becomes_the_name_of_who_spoke():
    give = HandOverTask("give it to me", ObjectDescription("bottle"), "me")

    assert with_names(give, {"me": "Ana"}).to == "Ana"
    assert with_names(WalkToTask("walk to me", "me"), {"me": "Ana"}).to == "Ana"
    assert with_names(WalkToTask("walk to Ben", "Ben"), {"me": "Ana"}).to == "Ben"


def test_what_was_seen_inside_needs_no_opening():
    commands = parse("take the bottle from the fridge").commands

    steps = prepared(commands, True, Known(in_view=lambda pick: pick.source == "fridge"))

    assert [type(step.command) for step in steps] == [WalkToTask, PickTask]


@pytest.mark.requirement("M3")
def test_a_door_is_opened_with_empty_hands_before_what_goes_behind_it_is_picked_up():
    assert kinds("put the green can into the fridge") == [WalkToTask, OpenTask, WalkToTask, PutInTask]
    assert kinds("pick up the green can and put it into the fridge") == [
        WalkToTask, OpenTask, WalkToTask, PickTask, PutInTask,
    ]  # fmt: skip


def test_a_fridge_that_the_sentence_opens_is_not_opened_twice_and_the_can_is_walked_to():
    assert kinds("open the fridge and put the green can in it") == [OpenTask, WalkToTask, PutInTask]


def test_what_a_hand_holds_is_put_down_while_the_other_things_are_done():
    commands = parse("put the green can into the fridge").commands

    steps = prepared(commands, True, Known(in_hand=lambda _put: True))

    assert [type(step.command) for step in steps] == [PlaceTask, WalkToTask, OpenTask, WalkToTask, PutInTask]
    assert steps[0].command.object == commands[0].object == steps[3].command.to


def test_what_a_hand_holds_is_not_looked_for_elsewhere():
    commands = parse("open the fridge and put the green can in it").commands

    steps = prepared(commands, True, Known(in_hand=lambda _put: True))

    assert [type(step.command) for step in steps] == [OpenTask, PutInTask]


def test_into_a_fridge_that_stands_open_things_are_put_from_where_they_are():
    commands = parse("put the green can into the fridge").commands

    assert [step.command for step in prepared(commands, True, Known(is_open=True))] == list(commands)


FLAT = Known(rooms=frozenset({"kitchen", "living room"}))


def walked(sentence, known=FLAT):
    """What is done in a flat, and where to."""
    return [
        (step.command.action, str(getattr(step.command, "to", None) or ""))
        for step in prepared(parse(sentence).commands, True, known)
    ]


@pytest.mark.requirement("L2")
def test_among_rooms_what_is_to_be_brought_is_walked_to_and_the_way_back_as_well():
    assert walked("bring Ana the red cup from the table") == [
        ("walk_to", "table"),
        ("walk_to", "red cup on the table"),
        ("pick", ""),
        ("walk_to", "Ana"),
        ("hand_over", "Ana"),
    ]


def test_what_is_taken_out_of_a_fridge_is_looked_for_there_alone():
    assert ("walk_to", "bottle on the fridge") in walked("take the bottle out of the fridge")


def test_what_is_to_be_put_somewhere_else_is_picked_up_before_the_robot_goes_there():
    assert walked("put the can on the shelf") == [
        ("walk_to", "can"), ("pick", ""), ("walk_to", "shelf"), ("place", ""),
    ]  # fmt: skip


def test_who_has_been_told_to_walk_to_the_table_does_not_walk_there_again():
    assert walked("walk to the table and pick up the red cup") == [("walk_to", "table"), ("pick", "")]


@pytest.mark.parametrize(
    ("sentence", "to"),
    [
        ("how many cups are on the counter?", "counter"),
        ("what is on the shelf?", "shelf"),
        ("is there a cup in the kitchen?", "kitchen"),
    ],
)
def test_what_is_asked_about_a_place_is_seen_from_there(sentence, to):
    assert walked(sentence)[:-1] == [("walk_to", to)]


@pytest.mark.parametrize(
    "sentence", ["what is in the fridge?", "how many cups are there?", "describe the cup"]
)
def test_for_what_has_no_place_or_is_behind_a_door_nobody_walks(sentence):
    assert len(walked(sentence)) == 1


def test_a_room_is_no_place_from_which_things_are_reached():
    said = "go to the kitchen and take the cup from the counter"

    assert walked(said)[1:] == [("walk_to", "counter"), ("walk_to", "cup on the counter"), ("pick", "")]


def test_what_a_hand_holds_is_brought_and_not_fetched():
    held = replace(FLAT, in_hand=lambda _task: True)

    assert walked("give Ana the cup", held) == [("walk_to", "Ana"), ("hand_over", "Ana")]
    assert walked("pick up the cup", held) == [("pick", "")]


def test_who_puts_something_beside_another_thing_walks_to_that_other_thing():
    assert ("walk_to", "white cup") in walked("put the red cup next to the white cup")


def test_several_things_at_once_are_taken_from_where_the_robot_stands():
    assert walked("pick up all the cups") == [("pick", "")]


STUCK = Failure.infeasible("the door is stuck")
UNSEEN = Failure.postcondition("no side table seen").because(Reason.NOT_SEEN)


class Notes:
    """A session that does everything it is told to, and finds Ana."""

    now_s = 0.0

    def __init__(self, fails="", failure=STUCK):
        self.toolbox = SimpleNamespace(
            can_walk=True,
            places=("kitchen", "living room"),
            grippers={"right": None},
            model=SimpleNamespace(description=load_description("talos")),
            detector=SimpleNamespace(labels=None, fronts=frozenset()),
        )
        self.told, self.fails, self.failure = [], fails, failure

    def request(self):
        return nullcontext()

    def task_steps(self, command, _timeout_s):
        self.told.append(command)
        yield
        fails = command.action == self.fails
        return TaskResult(
            command.text,
            command.action,
            "failed" if fails else "done",
            1,
            self.failure if fails else None,
            {"found": "Ana"},
            TaskTimes(),
            acted_on={"pick": "green bottle", "walk_to": "white cup"}.get(command.action),
        )


class Believed:
    """What is believed of the world, told beforehand."""

    def __init__(self, known=None):
        self.known = known or Known

    def note_where_asked(self):
        pass

    def with_other_furniture_named(self, command):
        return command


def carried_out(notes, sentence):
    return errand(notes, sentence, Believed())


def errand(notes, sentence, beliefs):
    return driven(Errand(notes, parse(sentence).commands, beliefs=beliefs).steps())


def test_an_errand_goes_back_to_who_spoke_and_hands_over_what_it_took():
    notes = Notes()

    results = carried_out(notes, "bring me the bottle from the fridge")

    assert [result.outcome for result in results] == ["done"] * 7
    back, give = notes.told[-2:]
    assert (back.to, give.to) == ("Ana", "Ana")
    assert give.object.name == "green bottle"


def test_an_errand_comes_back_to_where_the_robot_began_if_nobody_is_there():
    notes = Notes(fails="find")

    results = carried_out(notes, "walk to Ana and come back")

    assert [result.outcome for result in results] == ["failed", "done", "done"]
    assert [command.to for command in notes.told if isinstance(command, WalkToTask)] == ["Ana", "start"]


def in_the_flat(sentence, near=False):
    """In a flat, where nothing was seen yet; or everything, and at hand."""
    notes = Notes()
    errand(notes, sentence, Believed(lambda: replace(FLAT, is_near=lambda _nearness: near)))
    return notes.told


def test_the_thing_that_was_walked_to_is_the_one_that_is_picked_up_and_handed_over():
    told = in_the_flat("bring Ana the cup")

    walk, pick, _, give = told
    assert str(walk.to) == "cup"
    assert pick.object.name == "white cup"
    assert give.object.name == "green bottle"  # what the pick says that it took


def test_what_is_at_hand_is_not_walked_to():
    assert [command.action for command in in_the_flat("pick up the red cup", near=True)] == ["pick"]


def test_a_door_that_turns_out_to_stand_open_is_not_opened():
    notes = Notes()

    open_once_there = Believed(lambda: Known(is_open=bool(notes.told)))
    errand(notes, "put the green can into the fridge", open_once_there)

    assert [type(command) for command in notes.told] == [WalkToTask, WalkToTask, PutInTask]


def test_what_fails_on_the_way_ends_the_errand_with_its_own_reason():
    notes = Notes(fails="open")

    results = carried_out(notes, "bring me the bottle from the fridge")

    assert results[-1].action == "open"
    assert results[-1].failure.message == "the door is stuck"
    assert PickTask not in [type(command) for command in notes.told]


@pytest.mark.requirement("L2")
@pytest.mark.parametrize(
    "then", ["put it on the counter", "give it to Ben", "put it in the bowl", "put it next to the sink"]
)
def test_what_is_taken_to_a_room_and_then_put_somewhere_is_only_carried_there(then):
    commands = parse(f"take the red cup to the kitchen and {then}").commands

    carried = [step for step in prepared(commands, True, FLAT) if step.said == 1]

    assert [(step.command.action, step.command.to, step.carries) for step in carried] == [
        ("walk_to", "kitchen", 0)
    ]


@pytest.mark.parametrize("then", ["wave to Ben", "pick up the box", "put the box on the counter"])
def test_what_is_taken_to_a_room_and_left_is_put_down_there(then):
    commands = parse(f"take the red cup to the kitchen and {then}").commands

    said = [step.command for step in prepared(commands, True, FLAT) if step.said == 1]

    assert [command.action for command in said] == ["place"]


@pytest.mark.requirement("L2")
def test_what_is_put_back_is_carried_to_what_it_stood_on():
    back = PlaceTask("put it back", ObjectDescription("cup"), to=WHERE_IT_WAS)
    in_hand = replace(FLAT, in_hand=lambda _task: True, stood_on=lambda _task: "shelf 2")

    walk, place = prepared([back], True, in_hand)

    assert walk.command.to == ObjectDescription(name="shelf 2")
    assert place.command == back
    assert [
        step.command for step in prepared([back], True, replace(in_hand, stood_on=lambda _task: None))
    ] == [back]


@pytest.mark.requirement("M3")
def test_after_a_turn_things_are_walked_to_without_rooms_too():
    assert kinds("turn around; pick up the red cup") == [MoveTask, WalkToTask, PickTask]
    assert kinds("turn around; how many cups are on the table?") == [MoveTask, WalkToTask, CountTask]
    assert kinds("turn left by 10 degrees; pick up the red cup") == [MoveTask, PickTask]
    assert kinds("pick up the red cup; turn around") == [PickTask, MoveTask]


@pytest.mark.requirement("M3")
def test_a_robot_that_has_left_the_place_where_it_began_walks_to_what_is_meant():
    commands = parse("pick up the red cup").commands

    steps = prepared(commands, True, Known(is_away=True))

    assert [type(step.command) for step in steps] == [WalkToTask, PickTask]
    assert steps[0].unless_near is not None


@pytest.mark.requirement("M3")
def test_what_is_held_is_carried_to_other_furniture_without_rooms_too():
    commands = parse("pick up the blue cup and put it on the counter").commands

    steps = prepared(commands, True)

    assert [type(step.command) for step in steps] == [PickTask, WalkToTask, PlaceTask]
    assert steps[1].unless_near is not None  # nobody walks to the table that the robot stands before
    assert kinds("put the blue cup on the counter") == [PlaceTask]
    assert [type(step.command) for step in prepared(commands, False)] == [PickTask, PlaceTask]


@pytest.mark.requirement("M3")
def test_a_drawer_is_opened_before_something_is_put_in_unless_it_is_open():
    assert kinds("put the red cup in the drawer") == [OpenTask, PutInTask]
    assert kinds("put the red cup in the top drawer and close it") == [OpenTask, PutInTask, CloseTask]
    assert kinds("pick up the red cup and put it in the drawer") == [OpenTask, PickTask, PutInTask]
    assert kinds("open the drawer and put the red cup in it") == [OpenTask, PutInTask]
    commands = parse("put the red cup in the top drawer").commands
    (first, _) = prepared(commands, True)
    assert str(first.command.object) == "top drawer"
    assert [step.command for step in prepared(commands, True, Known(drawer_is_open=True))] == list(commands)


@pytest.mark.requirement("M3")
@pytest.mark.parametrize(
    ("said", "to"),
    [
        ("the top drawer of the shelf", "shelf"),
        ("the drawer", "drawers"),
        ("the drawer in the kitchen", "drawers"),
    ],
)
def test_what_is_held_is_carried_to_what_the_drawer_is_in(said, to):
    known = Known(rooms=frozenset({"kitchen"}), drawer_is_open=True)

    steps = prepared(parse(f"pick up the red cup and put it in {said}").commands, True, known)

    assert str(steps[-2].command.to) == to


@pytest.mark.requirement("M3")
def test_what_is_held_is_put_down_until_the_drawer_is_open():
    commands = parse("put the red cup in the drawer").commands

    steps = prepared(commands, True, Known(in_hand=lambda _put: True))

    assert [type(step.command) for step in steps] == [PlaceTask, OpenTask, PutInTask]
    assert steps[0].may_fail


@pytest.mark.parametrize(
    ("sentence", "actions"),
    [
        ("how many cups are on the side table?", ["count", "walk_to", "count"]),
        ("what is on the side table?", ["describe", "walk_to", "describe"]),
        ("how many cups are in the fridge?", ["count"]),
        ("how many cups are there?", ["count"]),
    ],
)
def test_what_is_asked_about_furniture_out_of_sight_is_walked_to_once(sentence, actions):
    notes = Notes(actions[0], UNSEEN)

    (*_, last) = errand(notes, sentence, Believed())

    assert [command.action for command in notes.told] == actions
    assert last.failure.root.message == "no side table seen"


@pytest.mark.parametrize(
    ("sentence", "source", "thing"),
    [
        ("pick up the cup from the other table", "other table", "cup on the other table"),
        ("pick up the cup from the top shelf", "top shelf", "cup on the top shelf"),
        ("pick up the ball from the box", "box", "ball in the box"),
    ],
)
def test_where_something_is_described_to_be_is_walked_to_as_where_it_is_named_to_be(sentence, source, thing):
    assert walked(sentence)[:2] == [("walk_to", source), ("walk_to", thing)]


@pytest.mark.parametrize("sentence", ["how many cups are on the other table?", "what is on the top shelf?"])
def test_what_is_asked_about_described_furniture_is_seen_from_there(sentence):
    assert [action for action, _ in walked(sentence)][:-1] == ["walk_to"]


def test_who_was_sent_elsewhere_walks_to_where_the_thing_is_said_to_be():
    assert walked("walk to the counter and pick up the cup from the other table")[1:3] == [
        ("walk_to", "other table"),
        ("walk_to", "cup on the other table"),
    ]


def test_what_is_fetched_after_a_door_was_opened_is_fetched_from_where_it_is_said_to_be():
    said = "take the bottle from the fridge, give it to Ana and pick up the cup from the other table"

    [*_, reach] = [step.command for step in steps(said) if type(step.command) is WalkToTask]

    assert str(reach.to) == "cup on the other table"


ROOMS = Known(rooms=frozenset({"kitchen", "hall"}))


def test_whoever_is_greeted_in_a_room_is_looked_for_by_the_greeting_itself():
    greeting = GreetTask("greet Ana in the kitchen", "Ana", "kitchen")

    assert [step.command for step in prepared([greeting], True, ROOMS)] == [greeting]


def test_somebody_at_the_table_is_seen_from_before_it():
    greeting = GreetTask("greet the person at the table", ObjectDescription("person"), "table")

    walk, _ = prepared([greeting], True, ROOMS)

    assert walk.command.to == "table"


def test_who_speaks_is_found_out_before_the_robot_goes_away_and_greets_them():
    walk, greeting = WalkToTask("go to the kitchen", "kitchen"), GreetTask("greet me", "me")

    first, *_ = prepared([walk, greeting], True, ROOMS)

    assert first.finds_who == "me"
    assert with_names(greeting, {"me": "Ana"}).person == "Ana"


def test_what_was_found_in_a_room_is_walked_to_before_it_is_taken():
    commands = parse("find the red cup in the office and take it").commands

    found = [step.command for step in prepared(commands, True, Known(rooms=frozenset({"office", "kitchen"})))]

    assert [type(command) for command in found] == [WalkToTask, FindTask, WalkToTask, PickTask]
    assert found[2].to == ObjectOf(0)


def test_what_a_hand_has_taken_is_not_walked_to():
    commands = parse("take the red cup and point at it").commands

    found = prepared(commands, True, Known(rooms=frozenset({"office", "kitchen"})))

    assert "come within reach of it" not in [step.command.text for step in found]
