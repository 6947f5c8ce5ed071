"""Episodes of people and names: what is drawn can be judged, and what is wrong is not called right."""

from types import SimpleNamespace

import numpy as np
import pytest

from executive.session.task_result import TaskResult
from kinematics.geometry import poses
from tools.evaluate.people.crowd import DOORWAY_M, FROM_DOORWAY_M, ends_at, room_of
from tools.evaluate.skills.episode import trial_of
from tools.evaluate.skills.naming import NamingJudge
from trees.failures import Failure
from trees.skills.greet import GreetTask
from trees.tasks import ObjectDescription


@pytest.mark.parametrize("seed", range(4))
def test_who_is_greeted_is_there_and_meant_by_nobody_else(seed):
    trial = trial_of("greet", seed)
    task, scene = trial.tasks[0], trial.scene
    aim = next(person for person in scene.people if person.name == trial.aim)
    there = [one for one in scene.people if task.source in (None, room_of(scene, *ends_at(one)))]

    assert isinstance(task, GreetTask)
    assert aim in there
    if isinstance(task.person, ObjectDescription):
        (trait,) = task.person.traits
        assert [one for one in there if trait in (one.posture, one.gesture, *one.clothes)] == [aim]
    else:
        assert task.person == aim.name


@pytest.mark.parametrize("seed", range(4))
def test_nobody_stands_or_walks_where_the_doorway_would_be_barred(seed):
    for person in trial_of("greet", seed).scene.people:
        for place in (person.position_m, *person.way_m):
            assert np.hypot(*np.subtract(place, DOORWAY_M)) >= FROM_DOORWAY_M


class _Truth:
    """A world that knows where its things are, and holds nothing."""

    time_s = 0.0
    contacts = SimpleNamespace(in_pads_only=list)

    def __init__(self, scene):
        self._places = {item.name: item.world_T_object for item in scene.objects}

    def objects(self):
        return tuple(self._places)

    def world_T_object(self, name):
        return self._places[name]

    def world_T_odom(self):
        return np.eye(4)


def judged(trial, result):
    truth = _Truth(trial.scene)
    toolbox = SimpleNamespace(world=SimpleNamespace(scene=SimpleNamespace(objects={})))
    assembly = SimpleNamespace(world=SimpleNamespace(truth=truth), session=SimpleNamespace(toolbox=toolbox))
    return NamingJudge(assembly, trial, np.random.default_rng(0)).verdict([result])


@pytest.fixture(scope="module")
def named():
    """An episode in which one thing alone is meant, and only to be found."""
    trials = (trial_of("names", seed) for seed in range(40))
    return next(one for one in trials if one.by == "name" and one.tasks[0].action == "find")


def found(place):
    x, y, z = place[:3, 3]
    return TaskResult("find", "find", "done", evidence={"x_m": x, "y_m": y, "z_m": z})


def test_the_thing_that_bears_the_name_is_right_and_another_is_wrong(named):
    places = {item.name: item.world_T_object for item in named.scene.objects}
    (meant,) = named.fitting
    other = next(name for name in places if name != meant)

    assert judged(named, found(places[meant])).done
    assert not judged(named, found(places[other])).done
    assert not judged(named, found(poses.translation(3.0, 0.0, 1.0))).done


def test_nothing_found_is_not_right(named):
    failed = TaskResult("find", "find", "failed", failure=Failure.postcondition("no such thing"))

    assert not judged(named, failed).done
