"""A hand feels its way to a button from where its approach has ended, and as far beyond as is asked."""

from dataclasses import replace

import pytest
from py_trees.common import Status

from tests.trees.leaf_inputs import hand_at_button
from trees.skills.controls.press_in import PressIn


def pressing(stage, **settings):
    """A hand that is about to press a button, of a robot that pushes in another way."""
    pushing = replace(stage.toolbox.model.description.pushing, **settings)
    model = stage.toolbox.model.twin()
    model.description = replace(model.description, pushing=pushing)
    return PressIn("press in", replace(stage.toolbox, model=model))


@pytest.mark.parametrize(("short_m", "past_m"), [(0.035, 0.02), (0.071, 0.02), (0.071, 0.035)])
def test_the_hand_goes_on_to_the_button_and_so_far_beyond(stage_with, short_m, past_m):
    stage = stage_with(walks=True)
    stage.fake.yielding.pull_n = 12.0
    leaf = pressing(stage, button_past_m=past_m)

    assert stage.run(leaf, **{**hand_at_button(stage), "short_m": short_m}) is Status.SUCCESS

    assert leaf.led.order.s_from == pytest.approx(short_m + past_m)


def test_what_resists_less_than_a_button_that_is_pressed_fully_is_none(stage_with):
    stage = stage_with(walks=True)
    stage.fake.yielding.pull_n = 6.0
    leaf = pressing(stage)

    assert stage.run(leaf, **hand_at_button(stage)) is Status.FAILURE

    assert "nothing resisted" in leaf.failure.message
