"""The reachability map of a robot as a file that can be read by eye."""

import importlib.resources

import pytest

from kinematics.model.reachability import GridAxis, ReachabilityMap
from robots.errors import DescriptionError
from robots.models.description import load_description
from robots.models.reachability_file import REACHABILITY, SCHEMA, reachability_text, read_reachability

LAYER = ((0.0, 1.0 / 9.0, 2.0 / 9.0), (1.0, 0.0, 0.5))


@pytest.fixture
def text():
    found = ReachabilityMap(
        GridAxis(0.2, 0.1, 2), GridAxis(-0.1, 0.1, 3), GridAxis(0.5, 0.1, 2), {"left": (LAYER, LAYER)}
    )
    return reachability_text(found, "somebody", "a command")


def test_what_is_written_is_read_again_to_a_ninth(text):
    read = read_reachability(text)

    assert (read.ahead, read.aside) == (GridAxis(0.2, 0.1, 2), GridAxis(-0.1, 0.1, 3))
    assert read.shares["left"][1][0] == pytest.approx(LAYER[0])
    assert read.shares["left"][1][1] == pytest.approx((1.0, 0.0, 4.0 / 9.0))
    assert list(read.shares) == ["left"]


def test_a_picture_has_what_is_ahead_above_and_what_is_left_on_the_left(text):
    assert '# 0.50 m\n"""\n4.9\n21.\n"""' in text


@pytest.mark.parametrize(
    ("before", "after", "reason"),
    [
        (f"schema = {SCHEMA}", f"schema = {SCHEMA + 1}", "make it anew"),
        ("4.9", "4.", "is not 2 by 3"),
        ("4.9", "4x9", "is no digit"),
        ("height = [0.5, 0.1, 2]", "height = [0.5, 0.1, 3]", "2 heights, not 3"),
        ("ahead = ", "forward = ", "cannot be read"),
        ("left = [", "left = ", "cannot be read"),
    ],
)
def test_a_file_that_is_broken_is_refused_with_the_reason(text, before, after, reason):
    assert before in text

    with pytest.raises(DescriptionError, match=reason):
        read_reachability(text.replace(before, after))


def test_the_stored_map_of_talos_comes_with_its_description():
    known = load_description("talos").reachability
    file = importlib.resources.files("robots.models") / "talos" / REACHABILITY

    assert known == read_reachability(file.read_text("utf-8"))
    assert set(known.shares) == {"left", "right"}


def test_a_robot_of_which_nobody_made_a_map_has_none():
    assert load_description("panda").reachability is None
