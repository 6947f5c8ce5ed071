"""How far a door is open, by what the hand felt where it is out of sight."""

import numpy as np
import pytest
from py_trees.common import Status

from kinematics.scene.opening_path import DoorArc
from trees.beliefs.openings.handles import HandleTarget
from trees.failures import Reason
from trees.skills.doors.open import seen_already
from trees.skills.doors.verify_opening import IsItSo, VerifyOpening
from trees.tasks import CloseTask, ObjectDescription, OpenTask

FRIDGE = ObjectDescription("fridge")
OPEN, CLOSE = OpenTask("open the fridge", FRIDGE), CloseTask("close the fridge", FRIDGE)


@pytest.fixture
def verify(stage):
    arc = DoorArc(np.array([0.8, 0.75]), 0.0, 1.0, 0.5, 0.05, 1.0)
    target = HandleTarget("door", "handle", "door", arc, 0.0, ("left",))

    def run(task, opening, kind=VerifyOpening, **inputs):
        leaf = kind("verify", stage.toolbox)
        stage.run(leaf, task=task, handle=target, opening=opening, **inputs)
        return leaf

    return run


def test_what_was_felt_counts_where_nothing_is_seen(verify):
    assert verify(OPEN, 1.3).status is Status.SUCCESS
    assert verify(CLOSE, 0.01).status is Status.SUCCESS


def test_a_door_that_nobody_has_opened_is_not_open(verify):
    assert verify(OPEN, 0.1).failure.message == "the door is not open"


def test_a_door_that_a_hand_has_led_open_did_not_stay_open(verify):
    assert verify(OPEN, 0.1, opened={"opening_deg": 80.0}).failure.message == "the door did not stay open"


def test_what_an_attempt_before_has_felt_does_not_tell_that_it_is_so_already(verify):
    failure = verify(CLOSE, -0.16, kind=IsItSo, opened={"opening_deg": -9.2}).failure

    assert failure.message == "the door is out of sight"


def test_what_was_seen_is_not_overruled_by_the_hand_from_where_it_is_out_of_sight(verify):
    felt = verify(OPEN, 0.1).failure

    assert seen_already(felt.because(Reason.SEEN_NOT_AS_ASKED))
    assert not seen_already(felt)
