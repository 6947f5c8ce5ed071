"""Every suite's episodes can be seen by the robot's own camera instead of the stub."""

from functools import partial

import pytest

from tools.evaluate.opening import episode as opening_episode
from tools.evaluate.opening.episode import OpeningOrder
from tools.evaluate.orders import EpisodeOrder
from tools.evaluate.scenes import seen_by
from tools.evaluate.skills import episode as skill_episode
from tools.evaluate.skills.episode import run_skill_episode, trial_of
from tools.evaluate.skills.handing_over import to_somebody_seen


class _AssembledError(Exception):
    """Says that a world was about to be made."""


@pytest.fixture
def assembled(monkeypatch):
    """The scenes that episodes are made of; none goes any further."""
    scenes = []

    def assemble(_robot, scene, *_args, **_kwargs):
        scenes.append(scene)
        raise _AssembledError

    monkeypatch.setattr(skill_episode, "assemble", assemble)
    monkeypatch.setattr(opening_episode, "assemble", assemble)
    return scenes


@pytest.mark.parametrize("kind", ["stub", "rgbd"])
def test_a_skill_s_episode_sees_as_its_order_says(assembled, kind):
    run_skill_episode("count", EpisodeOrder(3, perception=kind))

    assert [scene.perception.kind for scene in assembled] == [kind]


def test_a_door_s_episode_sees_as_its_order_says(assembled):
    opening_episode.run_opening(OpeningOrder("open", 0, "talos", perception="rgbd"))

    assert assembled[0].perception.kind == "rgbd"


def test_a_scene_of_which_nothing_else_is_said_stays_as_it_is():
    scene = trial_of("count", 0).scene

    assert seen_by(scene, None) is scene


def test_who_cannot_be_recognised_is_meant_by_the_place_where_the_person_stands():
    trials = map(partial(trial_of, "hand_over"), range(20))
    trial = next(one for one in trials if len(one.scene.people) > 1)

    said = to_somebody_seen(trial).sentence

    assert said in {f"give the {trial.aim} to the person on the {side}" for side in ("left", "right")}
    assert trial.tasks[-1].to not in said
