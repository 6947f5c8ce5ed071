"""From scores to what is told, what is asked, and what is left alone."""

import numpy as np

from robots.perception.labels.labeller import Boxes
from robots.perception.labels.naming import Labellers, namings

IMAGE = np.zeros((4, 4, 3), np.uint8)
BOX = Boxes(np.array([[0, 0, 4, 4]]), np.ones((4, 4), np.int32))


class Fixed:
    def __init__(self, scores, words=None):
        self._scores, self.words = scores, words

    def scores(self, image, boxes, words):
        return np.array([[self._scores.get(word, 0.0) for word in words]] * len(boxes))


def naming(scores):
    return namings(Fixed(scores), IMAGE, BOX, tuple(sorted(scores)))[0]


def test_a_sure_word_is_told():
    assert naming({"soup": 0.95, "tea": 0.1}).names == ("soup",)


def test_a_word_that_may_fit_is_no_name_but_may_be():
    one = naming({"soup": 0.5, "tea": 0.0})

    assert (one.names, one.maybe) == ((), ("soup",))


def test_two_words_that_fit_alike_are_both_possible():
    assert naming({"soup": 0.95, "broth": 0.93}).maybe == ("soup", "broth")


def test_what_fits_nothing_is_left_alone():
    assert naming({"soup": 0.1}) == namings(Fixed({}), IMAGE, BOX, ("x",))[0]


def test_each_labeller_is_asked_for_its_own_words_the_first_one_first():
    both = Labellers([Fixed({"soup": 0.9}, frozenset({"soup"})), Fixed({"soup": 0.1, "tea": 0.8})])

    scores = both.scores(IMAGE, BOX, ("soup", "tea"))

    assert scores.tolist() == [[0.9, 0.8]]
    assert both.words is None
    assert both.known == {"soup"}
