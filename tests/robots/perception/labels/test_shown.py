"""Things are told by views that somebody showed; what was never shown is not named."""

import numpy as np

from robots.perception.labels.naming import ASKED, TOLD, namings
from robots.perception.labels.shown import ShownLabeller
from tests.robots.perception.labels.conftest import package, table

WORDS = ("beans", "soup", "tea")


def test_each_thing_is_told_by_its_name_through_noise(gallery):
    image, boxes = table(package(1), package(2), package(0), noise=8.0)

    told = namings(ShownLabeller(gallery), image, boxes, WORDS)

    assert [one.names for one in told] == [("soup",), ("tea",), ("beans",)]


def test_what_was_never_shown_gets_no_name(gallery):
    image, boxes = table(package(77), package(78), package(79))

    told = namings(ShownLabeller(gallery), image, boxes, WORDS)

    assert [one.names for one in told] == [(), (), ()]


def test_two_names_for_the_same_look_are_both_possible_and_neither_is_told(gallery):
    twins = {**gallery, "broth": gallery["soup"]}
    image, boxes = table(package(1))

    scores = ShownLabeller(twins).scores(image, boxes, (*WORDS, "broth"))

    assert scores.max() < TOLD


def test_a_word_that_was_not_shown_scores_nothing(gallery):
    image, boxes = table(package(1))

    assert np.all(ShownLabeller(gallery).scores(image, boxes, ("coffee",)) == 0.0)


def test_the_same_picture_gives_the_same_scores(gallery):
    image, boxes = table(package(1), package(2))

    first, second = (ShownLabeller(gallery).scores(image, boxes, WORDS) for _ in range(2))

    assert np.array_equal(first, second)
    assert ASKED < TOLD
