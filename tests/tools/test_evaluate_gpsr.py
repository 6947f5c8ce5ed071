"""Commands of a field's exam can be carried out where they are given, and the oracle goes by the truth."""

import functools
import math
from types import SimpleNamespace

import numpy as np
import pytest

from executive.session.task_result import TaskResult
from executive.understanding.command_parser import parse
from executive.vocabulary.in_a_place import words_of_the_place
from kinematics.geometry import poses
from robots.scenes.scene_description import spoken_words
from tools.evaluate.gpsr.arena import carrier_of
from tools.evaluate.gpsr.command_trial import CommandTrial, command_trial
from tools.evaluate.gpsr.oracle import Oracle
from tools.evaluate.skills.episode import IN_PART, outcome_of
from tools.evaluate.skills.suite import Verdict
from trees.events import Said

TRIALS = 25


@functools.cache
def trial_of(seed):
    """Drawn where it is asked for: to collect tests takes no seconds."""
    return command_trial(np.random.default_rng([seed, 10]))


@pytest.fixture
def trial(seed):
    return trial_of(seed)


@pytest.mark.parametrize("seed", range(10))
def test_an_arena_has_rooms_things_and_people_where_a_command_says(trial):
    scene, words = trial.scene, trial.words

    assert len(scene.places) == 3
    assert 25 <= len(scene.objects) <= 40
    assert len({item.name for item in scene.objects}) == len(scene.objects)
    for item in scene.objects:
        assert words.where[item.name] == carrier_of(scene, item).name
    assert {words.room_of[person.name] for person in scene.people} == {place.name for place in scene.places}


@pytest.mark.parametrize("seed", range(TRIALS))
def test_who_speaks_stands_before_the_robot_and_nobody_else_is_nearly_as_near(trial):
    start = trial.scene.robot_start
    away_m = {one.name: math.dist(one.position_m, (start.x_m, start.y_m)) for one in trial.scene.people}
    x, y = next(one.position_m for one in trial.scene.people if one.name == trial.speaker)
    aside_rad = math.remainder(math.atan2(y - start.y_m, x - start.x_m) - start.yaw_rad, 2.0 * math.pi)

    assert away_m[trial.speaker] >= 1.2
    assert abs(aside_rad) <= 0.5
    others_m = [far for name, far in away_m.items() if name != trial.speaker]
    assert min(others_m) >= away_m[trial.speaker] + 0.4


@pytest.mark.parametrize("seed", range(TRIALS))
def test_things_that_are_called_by_their_look_look_like_no_other(trial):
    items = trial.scene.objects
    looks = [(item.kind, item.color) for item in items]
    plain = [(item.kind, item.color) for item in items if item.name == f"{item.color} {item.kind}"]

    assert [look for look in plain if looks.count(look) > 1] == []


@pytest.mark.requirement("U7")
def test_commands_are_understood_in_their_arena():
    lost = []
    for trial in map(trial_of, range(TRIALS)):
        with words_of_the_place(spoken_words(trial.scene)):
            if len(parse(trial.sentence).to_json()["tasks"]) != len(trial.does):
                lost.append(trial.sentence)

    assert len(lost) <= 0.1 * TRIALS, lost


class World:
    """A truth that says what a test says."""

    def __init__(self, base=(0.0, 0.0), places=(), touching=(), lift_m=0.0):
        self.time_s = 0.0
        self._base, self._places, self._lift_m = base, dict(places), lift_m
        self.contacts = SimpleNamespace(
            in_pads_only=lambda: dict.fromkeys(touching, "left"), of_object=lambda _name: ()
        )

    def world_T_base(self):
        return poses.translation(*self._base, 1.0)

    def world_T_object(self, name):
        return poses.translation(*self._places[name])

    def lift_m(self, _name):
        return self._lift_m


def judged(does, sentence, results, world, said=()):
    """What the oracle says of an end, with the first arena."""
    first = trial_of(0)
    trial = CommandTrial(first.scene, (), sentence=sentence, does=does, words=first.words)
    oracle = Oracle(world, trial, people={}, wave=None)
    for event in said:
        oracle.on_event(event)
    return oracle.verdict(results)


def done(**evidence):
    return TaskResult("", "", "done", evidence=evidence)


@pytest.fixture
def thing():
    return trial_of(0).scene.objects[0]


@pytest.mark.parametrize(
    ("touching", "lift_m", "held"), [(True, 0.1, True), (True, 0.0, False), (False, 0.1, False)]
)
def test_picked_is_what_a_hand_has_lifted(thing, touching, lift_m, held):
    world = World(touching=[thing.name] if touching else [], lift_m=lift_m)

    assert judged((("pick", thing.name),), f"take the {thing.name}", [done()], world).done is held


def test_placed_is_what_stands_on_what_was_named(thing):
    words = trial_of(0).words
    here = words.where[thing.name]
    there = next(name for name in words.furniture if name != here)
    world = World(places={thing.name: thing.world_T_object[:3, 3]})

    def told(place):
        does = (("pick", thing.name), ("place", place))
        return judged(does, f"put it on the {place}", [done(), done()], world)

    assert told(here).done
    assert told(there).why == f"the {thing.name} is not on the {there}"


def test_a_count_is_compared_with_what_is_there():
    scene, words = trial_of(0).scene, trial_of(0).words
    place = words.furniture[0]
    cups = sum(item.kind == "cup" and carrier_of(scene, item).name == place for item in scene.objects)
    says = f"tell me how many cups there are on the {place}"

    assert judged((("count", "cup"),), says, [done(count=cups)], World()).done
    assert not judged((("count", "cup"),), says, [done(count=cups + 1)], World()).done


def test_the_biggest_is_so_by_its_true_volume():
    scene, words = trial_of(0).scene, trial_of(0).words
    place = next(iter(words.where.values()))
    items = [item for item in scene.objects if carrier_of(scene, item).name == place]
    says = f"tell me what is the biggest object on the {place}"
    right = [
        item.name
        for item in items
        if judged((("describe", ""),), says, [done(names=item.name)], World()).done
    ]

    assert len(right) == 1
    everything = ", ".join(item.name for item in items)
    assert not judged((("describe", ""),), says, [done(names=everything)], World()).done


@pytest.mark.parametrize("seen_whole", [True, False])
def test_a_wrong_count_of_what_could_not_all_be_seen_is_told_with_a_reserve(seen_whole):
    place = trial_of(0).words.furniture[0]
    says = f"tell me how many cups there are on the {place}"

    verdict = judged((("count", "cup"),), says, [done(count=99, seen_whole=seen_whole)], World())

    assert (verdict.done, verdict.reserved) == (False, not seen_whole)


@pytest.mark.parametrize(
    ("right", "reserved", "outcome"),
    [(True, True, "done"), (False, True, IN_PART), (False, False, "done")],
)
def test_what_is_wrong_and_told_with_a_reserve_is_no_claim(right, reserved, outcome):
    assert outcome_of("gpsr", "done", Verdict(right, reserved=reserved)) == outcome


def test_the_room_is_the_one_in_which_the_robot_stands():
    room, other = (trial_of(0).scene.places[k] for k in (0, 1))
    world = World(base=room.position_m)

    assert judged((("walk_to", room.name),), f"go to the {room.name}", [done()], world).done
    assert not judged((("walk_to", other.name),), f"go to the {other.name}", [done()], world).done


@pytest.mark.parametrize(
    ("away_m", "text", "heard"),
    [(1.5, "dinner is ready", True), (4.0, "dinner is ready", False), (1.5, "hello", False)],
)
def test_a_message_is_for_whom_it_names_and_near_by(away_m, text, heard):
    person = trial_of(0).scene.people[0]
    world = World(base=(person.position_m[0] + away_m, person.position_m[1]))
    says = f"tell {person.name} that dinner is ready"

    verdict = judged((("say", "dinner is ready"),), says, [done()], world, [Said(1.0, text)])

    assert verdict.done is heard
