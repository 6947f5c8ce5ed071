"""What is not to be seen from where the robot stands is walked to, also without rooms on a map."""

from contextlib import nullcontext
from dataclasses import replace
from types import SimpleNamespace

import pytest

from executive.errands.errand import Errand
from executive.errands.prepared import Known
from executive.session.driver import driven
from executive.session.task_result import TaskResult, TaskTimes
from executive.understanding.command_parser import parse
from robots.models.description import load_description
from trees.failures import Failure, Reason


def unseen(name):
    return Failure.postcondition(f"no {name} seen", seen="table, red can").because(Reason.NOT_SEEN)


BODY = SimpleNamespace(description=load_description("talos"))


class Notes:
    """A session that notes what is asked of it; the first tasks fail as they are told to."""

    now_s = 0.0

    def __init__(self, *failures, can_walk=True):
        self.toolbox = SimpleNamespace(
            can_walk=can_walk,
            places=(),
            grippers={"right": None},
            model=BODY,
            detector=SimpleNamespace(labels=None, fronts=frozenset()),
        )
        self.told, self.went_to, self.failures = [], [], list(failures)

    def request(self):
        return nullcontext()

    def task_steps(self, command, _timeout_s):
        self.told.append(command.text)
        self.went_to += [command.to] if command.action == "walk_to" else []
        yield
        failure = self.failures.pop(0) if self.failures else None
        outcome = "failed" if failure else "done"
        found, named = {"found": "Ana"}, "blue bottle"
        times = TaskTimes()
        return TaskResult(command.text, command.action, outcome, 1, failure, found, times, acted_on=named)


class Here:
    """Nothing is held; what the robot stands before is told."""

    before = ()

    def __init__(self, notes):
        self.notes = notes

    def known(self):
        return Known(is_near=lambda wanted: wanted.within_reach and wanted.thing.kind in self.before)

    def note_where_asked(self):
        pass

    def with_other_furniture_named(self, command):
        return command


def results_of(notes, sentence, beliefs=Here):
    return driven(Errand(notes, parse(sentence).commands, beliefs=beliefs(notes)).steps())


def carried_out(notes, sentence, beliefs=Here):
    return [result.outcome for result in results_of(notes, sentence, beliefs)]


@pytest.mark.requirement("L6", "M6")
def test_what_was_not_seen_from_here_is_walked_to():
    notes = Notes(unseen("bottle"))

    assert carried_out(notes, "pick up the bottle") == ["failed", "done", "done"]
    assert notes.told == ["pick up the bottle", "come within reach of the bottle", "pick up the bottle"]


def test_what_was_done_before_is_not_done_again():
    notes = Notes(None, unseen("Tom"))

    assert carried_out(notes, "wave to Ana; give the can to Tom")[-1] == "done"
    assert notes.told.count("wave to Ana") == 1
    assert notes.went_to[-1] == "Tom"


def test_who_speaks_is_found_before_the_robot_goes_away():
    notes = Notes(unseen("bottle"))

    carried_out(notes, "bring me the bottle")

    assert notes.told[1] == "see who speaks"
    assert notes.went_to[-1] == "Ana"


def test_it_is_looked_for_once_and_told_as_what_was_asked_for():
    notes = Notes(unseen("bottle"), unseen("thing"))

    first, last = results_of(notes, "pick up the bottle")

    assert notes.told == ["pick up the bottle", "come within reach of the bottle"]
    assert (first.outcome, last.outcome) == ("failed", "failed")
    assert (last.text, last.action) == ("pick up the bottle", "pick")
    assert last.failure.message == "no bottle seen, nor elsewhere"
    assert last.failure.cause.message == "no thing seen"


class BeforeTheTable(Here):
    before = ("table",)


class WithTheCup(Here):
    """The first task picks it up."""

    def known(self):
        return replace(super().known(), in_hand=lambda _task: bool(self.notes.told))


def out_of_reach():
    return Failure.infeasible("no way to grasp it was found").because(Reason.NO_GRASP)


@pytest.mark.requirement("M5", "M6")
@pytest.mark.parametrize("sentence", ["pick up the bottle", "put the bottle on the table"])
def test_what_no_hand_gets_to_from_here_is_walked_to(sentence):
    notes = Notes(out_of_reach())

    assert carried_out(notes, sentence)[-1] == "done"
    assert notes.told[1] == "come within reach of the bottle"


class AcrossTheRoom(Here):
    """Opening the drawer leads the robot away."""

    def known(self):
        away = bool(self.notes.told)
        return replace(super().known(), is_away=away, drawer_is_open=away)


def test_what_goes_into_a_drawer_across_the_room_is_fetched_and_taken_there():
    notes = Notes(None, unseen("cup"))

    assert carried_out(notes, "put the cup in the top drawer", AcrossTheRoom)[-1] == "done"
    assert notes.told == [
        "open the top drawer",
        "put the cup in the top drawer",
        "come within reach of the cup",
        "pick up the cup",
        "walk to the drawers",
        "put the cup in the top drawer",
    ]


class AwayFromTheStart(Here):
    def known(self):
        return replace(super().known(), is_away=True)


def test_what_was_walked_to_and_is_not_there_is_not_walked_to_again():
    notes = Notes(None, unseen("cup"))

    assert carried_out(notes, "pick up the cup", AwayFromTheStart)[-1] == "failed"
    assert notes.told == ["come within reach of the cup", "pick up the cup"]


def test_what_cannot_be_put_down_from_here_is_taken_to_the_furniture():
    notes = Notes(Failure.infeasible("there is no spot on the shelf"))

    assert carried_out(notes, "put the cup on the shelf", WithTheCup)[-1] == "done"
    assert notes.told == ["put the cup on the shelf", "walk to the shelf", "put the cup on the shelf"]


@pytest.mark.requirement("M3")
def test_who_stands_too_far_away_to_take_it_is_walked_to():
    notes = Notes(Failure.infeasible("Ana stands 2.2 m away").because(Reason.PERSON_TOO_FAR))

    assert carried_out(notes, "give the cup to Ana", WithTheCup)[-1] == "done"
    assert notes.told == ["give the cup to Ana", "walk to Ana", "give the cup to Ana"]


def test_what_cannot_be_put_down_where_the_robot_stands_is_told_so():
    notes = Notes(Failure.infeasible("there is no spot on the table"))

    assert carried_out(notes, "put the cup on the table", BeforeTheTable) == ["failed"]


def test_what_cannot_be_grasped_from_nearby_either_is_told_so():
    notes = Notes(out_of_reach(), None, out_of_reach())

    assert carried_out(notes, "pick up the bottle") == ["failed", "done", "failed"]


class BesideTheBottle(Here):
    before = ("bottle",)


@pytest.mark.parametrize(
    ("notes", "sentence", "beliefs"),
    [
        (Notes(unseen("cup")), "pick up the cup on the table", BeforeTheTable),
        (Notes(unseen("cup"), can_walk=False), "pick up the cup", Here),
        (Notes(Failure.infeasible("the door is stuck")), "pick up the cup", Here),
        (Notes(Failure.postcondition("it slipped").because(Reason.SLIPPED)), "pick up the cup", Here),
        (Notes(out_of_reach()), "pick up the bottle", BesideTheBottle),
        (Notes(unseen("cup")), "pick up both cups", Here),
        (Notes(unseen("cup")), "count the cups", Here),
    ],
)
def test_not_all_that_fails_is_looked_for_elsewhere(notes, sentence, beliefs):
    assert carried_out(notes, sentence, beliefs) == ["failed"]
    assert len(notes.told) == 1


def test_what_no_hand_could_take_is_brought_nowhere():
    notes = Notes(Failure.infeasible("the bowl is too wide for the hand").because(Reason.TOO_WIDE))

    assert carried_out(notes, "put the bowl on the shelf") == ["failed"]
    assert notes.told == ["put the bowl on the shelf"]
