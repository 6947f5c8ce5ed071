"""Following somebody, whole: who is lost is looked for once, and followed on."""

from dataclasses import replace

import numpy as np
import pytest

from robots.fake.fake_world import person
from tests.trees.household_stage import said
from trees.build import build_tree
from trees.failures import Reason
from trees.skills.follow import FollowTask
from trees.skills.follow.settings import FollowSettings

QUICK = FollowSettings(lost_s=0.4, still_s=0.4, sets_out_s=5.0, losses=1)
STEP_M = 0.01
ANA = FollowTask("follow Ana", "Ana")


@pytest.fixture
def follows(stage_with, quick):
    """Runs the task while Ana walks ahead to some place, out of sight for some of the time."""

    def run(task=ANA, to_m=3.0, unseen_m=(9.0, 9.0), people=()):
        policy = replace(quick, task_timeout_s=200.0, skills=(*quick.skills, QUICK))
        stage = stage_with(person(), *people, walks=True, policy=policy)
        world, tree = stage.fake.world, build_tree(task, stage.toolbox)
        leaf = next(node for node in tree.root.iterate() if node.name == "walk behind")
        for _ in range(6000):
            if tree.status != "running":
                break
            x_m = float(world.object("Ana").world_T_object[0, 3])
            if leaf.status.value == "RUNNING" and x_m < to_m:
                world.move("Ana", (STEP_M, 0.0, 0.0))
            hidden = unseen_m[0] <= x_m <= unseen_m[1] and len(said(stage)) <= 0
            gone = unseen_m[1] < 0.0 and x_m >= -unseen_m[1]
            (world.hidden.add if hidden or gone else world.hidden.discard)("Ana")
            tree.tick()
            stage.fake.step()
        return stage, tree

    return run


def test_somebody_who_walks_and_stands_was_followed(follows):
    stage, tree = follows()

    assert tree.status == "success", tree.failure
    assert tree.evidence["followed"] == "Ana"
    assert said(stage) == []


def test_who_was_lost_and_is_seen_again_is_followed_on(follows):
    stage, tree = follows(unseen_m=(2.0, 9.0), to_m=3.0)

    assert said(stage) == ["I lost Ana."]
    assert tree.status == "success", tree.failure


def test_who_stays_lost_was_not_followed(follows):
    stage, tree = follows(unseen_m=(0.0, -2.0))

    assert tree.status == "failure"
    assert tree.failure.root.reason is Reason.PERSON_LOST
    assert said(stage) == ["I lost Ana."]


def test_it_says_whom_it_could_not_follow(follows):
    _, tree = follows(unseen_m=(0.0, -2.0))

    assert tree.failure.message.startswith("could not follow Ana")


def test_nobody_is_followed_in_the_place_of_who_was_lost(follows):
    stage, tree = follows(unseen_m=(0.0, -2.0), people=[person("Ben", (2.5, 0.8))])

    assert tree.failure.root.reason is Reason.PERSON_LOST
    assert np.hypot(stage.fake.motion.feet().x_m, stage.fake.motion.feet().y_m) < 2.0


def test_who_is_not_there_is_not_followed(follows):
    _, tree = follows(replace(ANA, person="Cleo"))

    assert tree.failure.is_unseen
