"""A mug is a cup, whatever the detector calls it."""

from dataclasses import replace

import numpy as np

from executive.understanding.canonical_detector import CanonicalDetector
from executive.understanding.canonical_words import canonical_kind
from kinematics.geometry.shapes import Cylinder
from robots.perception.detector import Detection, PerceptionFrame


class Seeing:
    labels = frozenset({"mug", "widget"})

    def __init__(self, *seen):
        self.frame = PerceptionFrame(0.0, 1, seen)

    def latest(self):
        return self.frame


def seen(kind, categories=(), names=()):
    solid = Cylinder(0.03, 0.1)
    return Detection("object", kind, "red", np.eye(4), solid, 0.9, names=names, categories=categories)


def told(*things):
    return CanonicalDetector(Seeing(*things), canonical_kind).latest().detections


def test_a_kind_is_told_by_the_word_of_sentences_and_keeps_its_own_as_a_name():
    (thing,) = told(seen("mug"))

    assert (thing.kind, thing.names) == ("cup", ("mug",))


def test_a_sort_that_is_written_as_many_is_told_as_one_too():
    (thing,) = told(seen("bottle", ("drinks",)))

    assert thing.kind == "bottle"
    assert "drink" in thing.categories


def test_a_name_is_told_as_it_is_and_by_the_word_of_sentences():
    (thing,) = told(seen("can", names=("cola",)))

    assert thing.names == ("cola", "coke")


def test_a_word_that_sentences_do_not_have_stays():
    assert told(seen("widgetron"))[0].kind == "widgetron"


def test_a_frame_that_needs_no_translation_is_the_same_frame():
    detector = Seeing(seen("cup"))

    assert CanonicalDetector(detector, canonical_kind).latest() is detector.frame


def test_labels_are_told_in_both_words():
    assert CanonicalDetector(Seeing(), canonical_kind).labels == {"mug", "cup", "widget"}


def test_what_sentences_call_the_same_as_its_name_is_a_name_of_it_too():
    carton = replace(seen("box"), names=("milk carton",))

    (thing,) = told(carton)

    assert thing.names == ("milk carton", "milk")
