"""Seeing that what was put down stands where it was meant to."""

from dataclasses import replace

import numpy as np
import pytest
from py_trees.common import Status

from kinematics.geometry import poses
from trees.beliefs.scene.held_object import HeldObject
from trees.port_values import Placement
from trees.skills.looking.look_at import LookAtTarget
from trees.skills.place.settings import PlaceSettings
from trees.skills.place.verify_placed import VerifyPlaced
from trees.skills.put_in.settings import PutInSettings


@pytest.fixture
def looking(knowing, target, planned):
    """The stage, with the head turned to the red cup on the table."""
    knowing.run(LookAtTarget("look", knowing.toolbox), grasp=planned.grasp, target=target)
    return knowing


def verify(stage, target, off_m, tolerance_m, taller_m=0.0):
    """Verify the cup against a placement that is beside it by so much, of a cup that is taller than seen."""
    meant = poses.translation(0.0, off_m, 0.5 * taller_m) @ target.odom_T_object
    leaf = VerifyPlaced("verify", stage.toolbox, tolerance_m)
    shape = replace(target.shape, height_m=target.shape.height_m + taller_m)
    held = HeldObject("red cup", "right", shape, np.eye(4))
    stage.leaf = stage.ready(
        leaf, stood={}, held=held, placement=Placement("right", meant, ("table",), (0.0, 0.0))
    )
    while stage.tick(leaf) is Status.RUNNING:
        pass
    return leaf


@pytest.mark.parametrize(("off_m", "so"), [(0.0, True), (0.016, True), (0.024, False)])
def test_what_is_seen_within_two_centimetres_of_its_spot_is_placed(looking, target, off_m, so):
    leaf = verify(looking, target, off_m, looking.toolbox.policy.of(PlaceSettings).placed_tolerance_m)

    assert (leaf.status is Status.SUCCESS) == so
    if so:
        assert looking.output("evidence")["off_m"] == pytest.approx(off_m, abs=2e-3)
    else:
        assert leaf.failure.message == "the red cup is not where it was put"
        assert leaf.failure.numbers["off_m"] == pytest.approx(off_m, abs=2e-3)


@pytest.mark.parametrize(("off_m", "so"), [(0.024, True), (0.034, False)])
def test_on_a_board_behind_a_door_it_may_stand_farther_from_its_spot(looking, target, off_m, so):
    leaf = verify(looking, target, off_m, looking.toolbox.policy.of(PutInSettings).shelved_tolerance_m)

    assert (leaf.status is Status.SUCCESS) == so


def test_what_is_not_seen_at_all_is_not_placed(looking, target):
    looking.fake.world.remove("red cup")
    for _ in range(3):  # until a picture shows it
        looking.fake.step()

    leaf = verify(looking, target, 0.0, looking.toolbox.policy.of(PlaceSettings).placed_tolerance_m)

    assert leaf.failure.message == "the red cup is not seen where it was put"


@pytest.mark.requirement("P2")
def test_what_seems_shorter_than_it_is_stands_where_its_foot_stands(looking, target):
    tolerance_m = looking.toolbox.policy.of(PlaceSettings).placed_tolerance_m

    leaf = verify(looking, target, 0.0, tolerance_m, taller_m=0.06)

    assert leaf.status is Status.SUCCESS
