"""Leading somebody somewhere, whole: what is said, and what is never begun."""

from dataclasses import replace

import pytest

from kinematics.geometry.planar import PlanarPose
from robots.fake.fake_world import person
from robots.scenes.scene_description import Region
from tests.trees.household_stage import said
from trees.build import build_tree
from trees.skills.guide import GuideTask
from trees.skills.guide.settings import GuideSettings

HALL = {"hall": Region("hall", (-1.5, 0.0), (1.5, 1.5))}
TASK = GuideTask("guide Ana to the hall", "Ana", to="hall")


@pytest.fixture
def leads(stage_with, quick):
    """Runs the task; Ana comes along behind the robot, or not."""

    def run(task=TASK, comes=True):
        policy = replace(quick, skills=(*quick.skills, GuideSettings(waits_s=0.5)))
        stage = stage_with(person("Ana", (1.3, 0.0)), walks=True, policy=policy)
        stage.toolbox = replace(stage.toolbox, places=HALL)
        tree = build_tree(task, stage.toolbox)
        for _ in range(6000):
            if tree.status != "running":
                break
            if comes and said(stage):
                _come(stage)
            tree.tick()
            stage.fake.step()
        return stage, tree

    return run


def _come(stage):
    feet = stage.fake.motion.feet()
    x, y = stage.fake.world.object("Ana").world_T_object[:2, 3]
    if (too_far := feet.distance_m(PlanarPose(x, y)) - 1.2) > 0.0:
        share = min(too_far, 0.3) / (too_far + 1.2)
        stage.fake.world.move("Ana", (share * (feet.x_m - x), share * (feet.y_m - y), 0.0))


def test_it_says_where_it_leads_and_that_it_has_arrived(leads):
    stage, tree = leads()

    assert tree.status == "success", tree.failure
    assert said(stage) == ["Please follow me to the hall.", "Here we are: the hall."]


@pytest.mark.requirement("L12")
def test_what_proves_it_is_that_both_are_there(leads):
    _, tree = leads()

    assert tree.evidence["guided"] == "Ana"
    assert tree.evidence["away_m"] <= GuideSettings().near_m


def test_who_does_not_come_was_not_led_there(leads):
    stage, tree = leads(comes=False)

    assert tree.status == "failure"
    assert "Ana does not come along" in tree.failure.message
    assert len(said(stage)) == 1


def test_nobody_is_led_to_what_is_not_known(leads):
    stage, tree = leads(replace(TASK, to="attic"))

    assert "I do not know where the attic is; the map has hall" in tree.failure.message
    assert said(stage) == []
    assert stage.fake.motion.feet().distance_m(PlanarPose()) < 0.1


def test_it_says_whom_it_could_not_lead_where(leads):
    _, tree = leads(comes=False)

    assert tree.failure.message.startswith("could not guide Ana to the hall")
