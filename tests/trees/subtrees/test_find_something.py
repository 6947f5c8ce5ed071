"""What is hidden from here is looked for from elsewhere."""

from kinematics.requests.view import ViewRequest
from robots.fake.fake_world import cup, table
from tests.trees.household_stage import BOX_BEFORE_IT, RED_CUP, asked, run, said
from trees.events import LeafFailed, NotSo
from trees.skills.telling.settings import TellingSettings
from trees.tasks import FindTask


def test_something_hidden_from_here_is_looked_for_from_elsewhere(stage_with):
    stage = stage_with(table(), cup(place_m=(0.52, -0.2)), BOX_BEFORE_IT)
    stage.fake.world.hidden.add("red cup")
    stage.when("peer", stage.fake.world.hidden.clear)

    tree = run(stage, FindTask("find the red cup", RED_CUP))

    assert tree.status == "success"
    assert tree.evidence["found"] == "red cup"
    assert len(asked(stage, ViewRequest)) == 1


def test_a_search_that_finds_it_at_last_tells_of_no_failures(stage_with):
    stage = stage_with(table(), cup(place_m=(0.52, -0.2)), BOX_BEFORE_IT)
    stage.fake.world.hidden.add("red cup")
    stage.when("peer", stage.fake.world.hidden.clear)

    run(stage, FindTask("find the red cup", RED_CUP))

    assert [event for event in stage.events if isinstance(event, LeafFailed)] == []
    assert any(isinstance(event, NotSo) for event in stage.events)


def test_what_is_hidden_from_everywhere_is_not_found(stage_with):
    stage = stage_with(table(), cup(place_m=(0.52, -0.2)), BOX_BEFORE_IT)
    stage.fake.world.hidden.add("red cup")

    tree = run(stage, FindTask("find the red cup", RED_CUP))

    assert tree.status == "failure"
    assert said(stage) == []
    assert 1 <= len(asked(stage, ViewRequest)) <= stage.toolbox.policy.of(TellingSettings).looks_past


def test_something_that_is_nowhere_is_not_found(stage):
    stage.fake.world.remove("red cup")

    tree = run(stage, FindTask("find the red cup", RED_CUP))

    assert (
        tree.failure.message == "could not find the red cup: no red cup seen, and every place was looked at"
    )
    assert said(stage) == []


def test_a_person_who_is_nowhere_is_not_found(stage):
    tree = run(stage, FindTask("find Ana", person="Ana"))

    assert tree.failure.message == "could not find Ana: no Ana seen"
