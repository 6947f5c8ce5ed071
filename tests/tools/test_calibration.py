"""Reliability of stated confidences: bins, intervals, the fit, the picture, and the robot that answers."""

from xml.etree import ElementTree

import numpy as np
import pytest

from kinematics.model.robot_model import RobotModel
from robots.models.description import load_description
from robots.scenes.scene_file import load_scene
from tools.calibration.answers import Answer
from tools.calibration.fit import fitted
from tools.calibration.quick_robot import QuickRobot
from tools.calibration.reliability import expected_error, reliability
from tools.calibration.reliability_plot import as_svg
from trees.skills.telling.telling_leaf import calibrated, log_odds
from trees.tasks import CountTask, ObjectDescription


def said(stated, right, count=1):
    return [Answer(number, "count", stated, stated, number < right, "") for number in range(count)]


def test_what_is_right_as_often_as_it_says_has_no_error():
    assert expected_error(said(0.8, 80, 100) + said(0.95, 95, 100)) == pytest.approx(0.0)


def test_overconfidence_is_its_distance_weighted_by_the_answers():
    assert expected_error(said(0.95, 50, 100) + said(0.75, 75, 100)) == pytest.approx(0.225)


def test_the_interval_of_a_share_is_wilsons():
    (only,) = reliability(said(0.75, 8, 10))

    assert (only.count, only.right) == (10, 0.8)
    assert (only.low, only.high) == (pytest.approx(0.4902, abs=1e-4), pytest.approx(0.9433, abs=1e-4))


@pytest.mark.parametrize("stated", [0.0, 0.3, 0.5, 0.99, 1.0])
def test_every_confidence_is_in_one_bin(stated):
    assert [item.count for item in reliability(said(stated, 1, 3))] == [3]


def test_the_fit_finds_the_line_that_made_the_answers():
    rng = np.random.default_rng(4)
    raw = rng.uniform(0.2, 0.995, 20_000)
    right = rng.random(20_000) < [calibrated(float(one), 0.6, -0.4) for one in raw]

    slope, offset = fitted(
        [Answer(0, "count", 0.5, float(p), bool(r)) for p, r in zip(raw, right, strict=True)]
    )

    assert (slope, offset) == (pytest.approx(0.6, abs=0.05), pytest.approx(-0.4, abs=0.1))


def test_a_line_of_slope_one_leaves_a_confidence_as_it_is_but_for_certainty():
    assert calibrated(0.7, 1.0, 0.0) == pytest.approx(0.7)
    assert calibrated(1.0, 1.0, 0.0) == pytest.approx(0.999)
    assert log_odds(0.5) == 0.0


def test_the_picture_has_a_point_for_every_bin():
    found = {"declared": said(0.95, 90, 100) + said(0.75, 6, 10), "poor": said(0.55, 3, 10)}

    picture = ElementTree.fromstring(as_svg(found))

    points = list(picture.iter("{http://www.w3.org/2000/svg}circle"))
    assert len(points) == 3
    assert "declared camera: 110 answers" in ElementTree.tostring(picture, encoding="unicode")


def test_the_quick_robot_counts_what_is_there_by_looking():
    scene = load_scene("tabletop")
    robot = QuickRobot(RobotModel(load_description("talos")), scene, 3)

    tree = robot.do(CountTask("how many cups are there", ObjectDescription("cup")))

    assert tree.status == "success"
    assert tree.evidence["count"] == 1
    assert 0.0 < tree.evidence["confidence"] <= 1.0
