"""A hand that loses its hold early, at a strong pull, of what was shut before, slipped off what is stuck."""

from dataclasses import replace

import numpy as np
import pytest
from py_trees.common import Status

from tests.trees.cabinet_seen import CABINET, believed, seen
from tests.trees.leaf_inputs import handle_in_hand
from trees.beliefs.openings.handles import INSIDE_KINDS, SHUT, handles_in
from trees.skills.doors.handle.lead_handle import LeadHandle, is_stuck, slips_off


@pytest.fixture
def lost(new_stage):
    """How it fails to lead a handle that the hand loses, which was seen so far open, with such a pull."""

    stage = new_stage(walks=True)

    def lead(opening, pull_n):
        given = handle_in_hand(stage)
        held = given["held"]
        given["held"] = replace(held, target=replace(held.target, opening=opening))
        stage.fake.yielding.pull_n = pull_n
        leaf = stage.ready(LeadHandle("lead", stage.toolbox), **given)
        assert stage.tick(leaf) is Status.RUNNING
        stage.fake.grippers[held.grasp.hand].holding = None
        while stage.tick(leaf) is Status.RUNNING:
            stage.fake.step()
        return leaf.failure

    return lead


def test_a_hand_that_slips_off_what_is_shut_has_found_it_stuck(lost):
    failure = lost(0.0, 49.9)

    assert is_stuck(failure)
    assert slips_off(failure)


def test_what_was_seen_ajar_has_moved_and_is_not_stuck(lost):
    assert not is_stuck(lost(2.0 * SHUT["door"], 49.9))


def test_a_hand_that_loses_its_hold_without_a_pull_has_found_nothing(lost):
    failure = lost(0.0, 20.0)

    assert not is_stuck(failure)
    assert "lost the handle" in failure.message


def test_what_is_in_the_next_drawer_stays_where_it_is(new_stage):
    stage = new_stage(walks=True)
    held = handle_in_hand(stage)["held"]
    look = seen(CABINET, top_drawer=0.05, middle_drawer=0.05)
    target = next(one for one in handles_in(look) if one.moves.part == "middle drawer")
    stage.told.update(stage.told.scene.with_objects(believed(look).objects.values()))
    leaf = stage.ready(
        LeadHandle("lead", stage.toolbox),
        held=replace(held, target=target, path=target.path),
        lead_to=target.open_to,
    )
    assert stage.tick(leaf) is Status.RUNNING
    while stage.tick(leaf) is Status.RUNNING:
        stage.fake.step()

    moved = {
        one.moves.part
        for name, one in look.items()
        if one.kind in INSIDE_KINDS
        and not np.allclose(stage.told.scene.objects[name].world_T_object, one.odom_T_object, atol=1e-6)
    }
    assert moved == {"middle drawer"}
