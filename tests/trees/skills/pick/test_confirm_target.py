import pytest
from py_trees.common import Status

from trees.skills.pick.confirm_target import ConfirmTarget


def confirm(stage, planned, target):
    planned.play("reach")
    leaf = ConfirmTarget("confirm target", stage.toolbox)
    return leaf, stage.run(leaf, target=target)


def test_a_target_that_stayed_is_confirmed_and_the_world_stays_as_it_was(knowing, planned, target):
    version = knowing.told.scene.version

    _, status = confirm(knowing, planned, target)

    assert status is Status.SUCCESS
    assert knowing.told.scene.version == version


@pytest.mark.requirement("M2", "M4")
def test_a_target_that_moved_is_noticed_with_the_distance(knowing, planned, target):
    knowing.fake.world.move("red cup", (0.0, 0.04, 0.0))

    leaf, status = confirm(knowing, planned, target)

    assert status is Status.FAILURE
    assert leaf.failure.message == "the red cup is not where it was"
    assert leaf.failure.numbers["moved_m"] == pytest.approx(0.04, abs=1e-6)


def test_a_target_that_moved_less_than_the_tolerance_is_confirmed(knowing, planned, target):
    knowing.fake.world.move("red cup", (0.0, 0.01, 0.0))

    _, status = confirm(knowing, planned, target)

    assert status is Status.SUCCESS


def test_a_target_that_should_be_seen_and_is_not_has_gone(knowing, planned, target, monkeypatch):
    monkeypatch.setattr("trees.skills.pick.confirm_target.behind_a_hand", lambda *args: False)
    knowing.fake.world.hidden.add("red cup")

    leaf, status = confirm(knowing, planned, target)

    assert status is Status.FAILURE
    assert leaf.failure.message == "the red cup is no longer there"


def test_a_target_behind_the_hand_is_taken_to_be_where_it_was(knowing, planned, target, monkeypatch):
    monkeypatch.setattr("trees.skills.pick.confirm_target.behind_a_hand", lambda *args: True)
    knowing.fake.world.hidden.add("red cup")

    leaf, status = confirm(knowing, planned, target)

    assert status is Status.SUCCESS
    assert leaf.feedback_message.startswith("hidden")
