"""Which hand is meant where "hand" is left out."""

import pytest

from executive.understanding.command_parser import parse


@pytest.mark.parametrize("before", ["with the left hand", "with your left", "with the left"])
@pytest.mark.parametrize("next_one", [". Bring me the plate.", ", wave to Ana", " and wave to Ana"])
def test_the_right_behind_a_thing_is_the_hand_that_takes_it(before, next_one):
    tasks = parse(f"pick up the cup {before} and the bottle with the right{next_one}").to_json()["tasks"]

    assert [task.get("hand") for task in tasks[:2]] == ["left", "right"]
    assert not any("hand" in task for task in tasks[2:])


@pytest.mark.parametrize("sentence", ["take the cup with the right handle", "take the left", "use the left"])
def test_a_side_alone_is_no_hand(sentence):
    assert parse(sentence).commands == ()
