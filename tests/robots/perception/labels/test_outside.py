"""Detectors of other packages: what they find is matched to what stands out in depth."""

import importlib.metadata

import numpy as np

from robots.perception.labels.outside import DetectorLabeller, Found, outside_labellers
from tests.robots.perception.labels.conftest import PLACES, package, table


class Detector:
    def __init__(self, *found):
        self._found = found

    def detect(self, rgb, words):
        return self._found


def test_a_box_of_a_detector_names_the_thing_that_it_covers():
    image, boxes = table(package(1), package(2))
    labeller = DetectorLabeller(Detector(Found("mug", 0.8, PLACES[1])))

    assert labeller.scores(image, boxes, ("mug",)).tolist() == [[0.0], [0.8]]


def test_a_mask_counts_more_than_its_box():
    image, boxes = table(package(1), package(2))
    mask = boxes.pieces == 1
    labeller = DetectorLabeller(Detector(Found("mug", 0.8, PLACES[1], mask)))

    assert labeller.scores(image, boxes, ("mug",)).tolist() == [[0.8], [0.0]]


def test_what_a_detector_finds_elsewhere_names_nothing():
    image, boxes = table(package(1))
    labeller = DetectorLabeller(Detector(Found("mug", 0.8, (150, 10, 190, 90)), Found("jar", 0.9, PLACES[0])))

    assert not labeller.scores(image, boxes, ("mug",)).any()


def test_a_package_that_cannot_be_used_is_left_out_with_a_complaint(monkeypatch):
    class Broken:
        name = "owl"

        def load(self):
            raise RuntimeError("no weights")

    monkeypatch.setattr(importlib.metadata, "entry_points", lambda group: [Broken()])

    made, complaints = outside_labellers()

    assert made == []
    assert complaints == ["labeller 'owl': RuntimeError: no weights"]
    assert np.size(made) == 0
