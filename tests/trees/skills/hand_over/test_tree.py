"""Giving things to people: whoever pulls, nobody, somebody else, and what is never claimed."""

import numpy as np
import pytest

from kinematics.ik.body_gaze import off_axis_rad
from kinematics.requests.gesture import OfferRequest
from robots.fake.fake_world import cup, person, table
from tests.trees.household_stage import ANA, RED_CUP, asked, run
from trees.failures import Reason
from trees.tasks import HandOverTask, ObjectDescription, PickTask


@pytest.mark.parametrize("force", [(5.0, 0.0, 0.0), (3.0, 3.0, 0.0), (0.0, 0.0, 5.0)])
def test_an_object_is_given_to_whom_pulls(stage_with, force):
    stage = stage_with(table(), cup(), ANA)
    stage.when("wait for the pull", lambda: stage.fake.pull_n.update(right=force), 10)
    stage.when("let it go", lambda: stage.fake.world.move("red cup", (0.3, 0.0, 0.25)))

    tree = run(stage, HandOverTask("give it to Ana", RED_CUP, "Ana"))

    assert tree.status == "success"
    assert tree.evidence["pull_n"] >= 3.0
    assert len(asked(stage, OfferRequest)) == 1
    assert not stage.told.scene.attached


@pytest.mark.parametrize("force", [(2.0, 0.0, 0.0), (0.0, 0.0, 0.0), (-9.0, 0.0, 0.0), (0.0, 0.0, -9.0)])
def test_what_nobody_takes_is_taken_back(stage_with, force):
    stage = stage_with(table(), cup(), ANA)
    stage.when("wait for the pull", lambda: stage.fake.pull_n.update(right=force), 10)

    tree = run(stage, HandOverTask("give it to Ana", RED_CUP, "Ana"))

    assert tree.status == "failure"
    assert "nobody took the red cup" in tree.failure.message
    assert stage.fake.world.carried_by("red cup") == "right"


def test_what_slips_out_of_an_offering_hand_was_not_taken(stage_with):
    stage = stage_with(table(), cup(), ANA)
    stage.when("wait for the pull", lambda: stage.fake.world.remove("red cup"), 10)

    tree = run(stage, HandOverTask("give it to Ana", RED_CUP, "Ana"))

    assert tree.status == "failure"
    assert "the red cup slipped out of the right hand" in tree.failure.message
    assert not stage.told.scene.attached


def test_a_dropped_gift_is_not_claimed(stage_with):
    stage = stage_with(table(), cup(), ANA)
    stage.when("wait for the pull", lambda: stage.fake.pull_n.update(right=(5.0, 0.0, 0.0)), 10)
    stage.when("let it go", lambda: stage.fake.world.drop("red cup"))

    tree = run(stage, HandOverTask("give it to Ana", RED_CUP, "Ana"))

    assert tree.status == "failure"
    assert "the red cup was dropped onto the table" in tree.failure.message


@pytest.mark.parametrize(("far_m", "status"), [(0.35, "success"), (0.12, "failure")])
def test_what_was_carried_away_and_stands_there_was_taken(stage_with, far_m, status):
    def put_aside():
        stage.fake.world.drop("red cup")
        stage.fake.world.move("red cup", (far_m, 0.0, 0.0))

    stage = stage_with(table(), cup(), ANA)
    stage.when("wait for the pull", lambda: stage.fake.pull_n.update(right=(5.0, 0.0, 0.0)), 10)
    stage.when("let it go", put_aside)

    tree = run(stage, HandOverTask("give it to Ana", RED_CUP, "Ana"))

    assert tree.status == status


def test_a_gift_that_is_nowhere_to_be_seen_is_not_claimed(stage_with):
    stage = stage_with(table(), cup(), ANA)
    stage.when("wait for the pull", lambda: stage.fake.pull_n.update(right=(5.0, 0.0, 0.0)), 10)
    stage.when("let it go", lambda: stage.fake.world.remove("red cup"))

    tree = run(stage, HandOverTask("give it to Ana", RED_CUP, "Ana"))

    assert tree.status == "failure"
    assert "was let go, and is not seen with Ana" in tree.failure.message


def test_who_took_it_is_looked_at_with_face_and_hands(stage_with):
    stage = stage_with(table(), cup(), person("Ana", (1.0, -0.5)))
    stage.when("wait for the pull", lambda: stage.fake.pull_n.update(right=(5.0, 0.0, 0.0)), 10)
    stage.when("let it go", lambda: stage.fake.world.remove("red cup"))
    seen_rad = []

    def note():
        model, q = stage.toolbox.model, stage.toolbox.motion.reference()
        ana = stage.told.scene.objects["Ana"]
        at, crown_m = ana.world_T_object[:2, 3], ana.world_T_object[2, 3] + 0.5 * ana.shape.height_m
        heights = (crown_m, 1.05)
        seen_rad.extend(off_axis_rad(model, q, np.array([*at, z])) for z in heights)

    stage.when("verify taken ahead", note)
    run(stage, HandOverTask("give it to Ana", RED_CUP, "Ana"))

    camera = stage.toolbox.model.description.camera
    assert len(seen_rad) == 2
    assert max(seen_rad) < 0.5 * camera.vertical_fov_rad


@pytest.mark.requirement("M2", "M3")
def test_what_somebody_else_took_is_not_claimed(stage_with):
    stage = stage_with(table(), cup(), ANA, person("Ben", (1.25, -0.7)))
    stage.when("wait for the pull", lambda: stage.fake.pull_n.update(right=(5.0, 0.0, 0.0)), 10)
    stage.when("let it go", lambda: stage.fake.world.move("red cup", (0.45, -0.35, 0.25)))

    tree = run(stage, HandOverTask("give it to Ana", RED_CUP, "Ana"))

    assert tree.status == "failure"
    assert "the red cup was taken by Ben, not by Ana" in tree.failure.message


@pytest.mark.requirement("M3")
def test_nothing_is_held_out_to_who_does_not_come_for_it(stage_with):
    stage = stage_with(table(), cup(), person("Ana", (2.8, 0.1)))

    tree = run(stage, HandOverTask("give it to Ana", RED_CUP, "Ana"))

    assert tree.failure.root.message == "Ana stands 2.8 m away"
    assert tree.failure.root.reason is Reason.PERSON_TOO_FAR
    assert stage.fake.world.carried_by("red cup") == "right"


def test_another_cup_like_the_gift_is_not_taken_for_a_dropped_one(stage_with):
    stage = stage_with(table(), cup(), cup("red cup 2", "red", (0.45, -0.45)), ANA)
    stage.play(stage.pick(PickTask("pick it up", ObjectDescription("cup", "red", ordinal="leftmost"))))
    stage.when("wait for the pull", lambda: stage.fake.pull_n.update(right=(5.0, 0.0, 0.0)), 10)
    stage.when("let it go", lambda: stage.fake.world.move("red cup", (0.3, 0.0, 0.25)))

    tree = run(stage, HandOverTask("give it to Ana", RED_CUP, "Ana"))

    assert tree.status == "success"
