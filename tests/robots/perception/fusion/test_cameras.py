"""Two cameras see better than one, and one of them may fail."""

from dataclasses import replace

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball, Box, Cylinder
from robots.perception.fusion.cameras import PlacedCamera, seen_by_all
from robots.perception.object_estimate import ObjectEstimate
from robots.perception.position_error import PositionError, alike_in_all_directions


def cup(place_m, sigma_m=0.005, color="red", error=True):
    declared = alike_in_all_directions(sigma_m, 0.0, 0.01) if error else None
    place = poses.translation(*place_m)
    return ObjectEstimate("object", "cup", color, place, Cylinder(0.03, 0.1), 0.9, 8, 0.003, error=declared)


@pytest.mark.requirement("P3")
def test_a_second_camera_makes_places_better():
    rng = np.random.default_rng(3)
    alone, both = [], []
    for _ in range(100):
        truth = rng.uniform(-1.0, 1.0, 3)
        head, fixed = (cup(truth + rng.normal(0.0, 0.005, 3)) for _ in range(2))
        (fused,) = seen_by_all({"head camera": [head], "ceiling camera": [fixed]}).estimates
        alone.append(np.linalg.norm(head.odom_T_object[:3, 3] - truth))
        both.append(np.linalg.norm(fused.odom_T_object[:3, 3] - truth))

    assert np.median(both) < 0.85 * np.median(alone)


@pytest.mark.requirement("P3")
def test_the_better_camera_counts_for_more():
    (fused,) = seen_by_all({"a": [cup((0, 0, 0), 0.001)], "b": [cup((0.01, 0, 0), 0.010)]}).estimates

    assert 0.0 < fused.odom_T_object[0, 3] < 0.001


@pytest.mark.requirement("P3")
def test_cameras_that_differ_are_told_and_not_averaged():
    seen = seen_by_all({"a": [cup((0, 0, 0))], "b": [cup((0.04, 0, 0))]})

    ((thing, innovation),) = seen.differing
    assert thing.kind == "cup"
    assert innovation.size == pytest.approx(0.04)
    assert seen.estimates[0].odom_T_object[0, 3] == 0.0


@pytest.mark.requirement("P3")
def test_a_covered_camera_is_noticed_and_the_other_goes_on():
    seen = seen_by_all({"a": [], "b": [cup((0, 0, 0))]})

    assert seen.blind == ("a",)
    assert len(seen.estimates) == 1


def test_where_nothing_stands_nobody_is_blind():
    assert seen_by_all({"a": [], "b": []}).blind == ()


def test_what_one_camera_alone_sees_is_there():
    seen = seen_by_all({"a": [cup((0, 0, 0))], "b": [cup((0, 0, 0)), cup((0.5, 0, 0))]})

    assert len(seen.estimates) == 2


def test_things_of_other_colours_are_other_things():
    seen = seen_by_all({"a": [cup((0, 0, 0))], "b": [cup((0.06, 0, 0), color="blue")]})

    assert [one.color for one in seen.estimates] == ["red", "blue"]


@pytest.mark.requirement("P3")
def test_what_two_cameras_take_for_two_colours_is_one_thing_of_the_surer_ones():
    white, grey = cup((0, 0, 0), color="white"), cup((0.01, 0, 0), color="grey")
    seen = seen_by_all({"a": [replace(grey, confidence=0.5)], "b": [white]})

    assert [one.color for one in seen.estimates] == ["white"]


@pytest.mark.requirement("P3")
def test_what_two_cameras_take_for_two_kinds_is_one_thing_with_the_better_measured_shape():
    box = replace(
        cup((0.01, 0, 0)), kind="box", shape=Box((0.06, 0.06, 0.1)),
        error=alike_in_all_directions(0.005, 0.0, 0.2), confidence=0.4,
    )  # fmt: skip
    (fused,) = seen_by_all({"a": [box], "b": [cup((0, 0, 0))]}).estimates

    assert (fused.kind, fused.shape) == ("cup", Cylinder(0.03, 0.1))


def test_a_ball_in_a_bowl_is_not_the_bowl():
    bowl = replace(cup((0, 0, 0)), kind="bowl", shape=Cylinder(0.09, 0.05))
    seen = seen_by_all({"a": [bowl], "b": [replace(cup((0, 0, 0)), kind="ball", shape=Ball(0.03))]})

    assert len(seen.estimates) == 2


def test_twins_beside_each_other_stay_two():
    """Each is the one that it is nearest to, though one camera is off by a quarter of their distance."""
    a, b = cup((0, 0, 0)), cup((0.04, 0, 0))
    seen = seen_by_all({"a": [a, b], "b": [cup((0.05, 0, 0)), cup((0.01, 0, 0))]})

    assert len(seen.estimates) == 2
    assert seen.differing == ()


@pytest.mark.requirement("P3")
def test_a_slim_box_as_high_as_a_bottle_at_its_place_is_the_bottle():
    """From one side alone little of a round thing is seen."""
    bottle = replace(cup((0, 0, 0)), kind="bottle", shape=Cylinder(0.0275, 0.212))
    sliver = replace(cup((0.012, 0, 0)), kind="box", shape=Box((0.023, 0.031, 0.211)), confidence=0.7)
    (fused,) = seen_by_all({"a": [bottle], "b": [sliver]}).estimates

    assert fused.kind == "bottle"


@pytest.mark.requirement("P3")
def test_what_a_camera_has_in_common_stays_common_by_its_share():
    """Of two cameras alike, a quarter of each one's variance: the mean of the two."""
    common = np.diag([4e-6, 4e-6, 1e-6])
    error = PositionError(common + 1e-6 * np.eye(3), np.zeros((3, 3)), 0.01, common)
    one = replace(cup((0, 0, 0)), error=error)
    (fused,) = seen_by_all({"a": [one], "b": [one]}).estimates

    assert fused.error.shared_m2 == pytest.approx(0.5 * common)
    assert fused.error.covariance_m2 == pytest.approx(0.5 * error.covariance_m2)


def test_a_camera_should_show_what_is_well_within_its_pictures():
    camera = PlacedCamera("ceiling camera", None, poses.transform(poses.rotation_x(np.pi), (0, 0, 2.0)))

    assert camera.should_show(np.array([0.1, 0.1, 0.8]))
    assert not camera.should_show(np.array([2.0, 0.0, 0.8]))
    assert not camera.should_show(np.array([0.0, 0.0, 1.9]))


def test_without_declared_errors_the_first_camera_counts():
    first = cup((0, 0, 0), error=False)
    seen = seen_by_all({"a": [first], "b": [replace(first, odom_T_object=poses.translation(0.02, 0, 0))]})

    assert seen.estimates == (first,)
