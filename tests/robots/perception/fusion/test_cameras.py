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


COMMON = np.diag([9e-6, 9e-6, 4e-6])


def two_views(rng, count=4, own_m=0.001):
    """Things as two cameras show them whose calibrations are wrong, and where the things are."""
    error = PositionError(COMMON + own_m**2 * np.eye(3), np.zeros((3, 3)), 0.01, COMMON)
    places = np.column_stack([np.arange(count) * 0.15, rng.uniform(-0.2, 0.2, count), np.zeros(count)])
    shown = []
    for _ in range(2):
        wrong = rng.normal(0.0, np.sqrt(np.diag(COMMON))) + rng.normal(0.0, own_m, places.shape)
        shown.append([replace(cup(place), error=error) for place in places + wrong])
    return places, *shown


@pytest.mark.requirement("P3")
def test_what_both_cameras_show_betters_the_place_of_what_only_one_shows():
    rng = np.random.default_rng(5)
    alone, both = [], []
    for _ in range(200):
        places, first, second = two_views(rng)
        seen = seen_by_all({"a": first, "b": second[1:]})
        (fused,) = [one for one in seen.estimates if abs(one.odom_T_object[0, 3] - places[0, 0]) < 0.07]
        alone.append(np.linalg.norm(first[0].odom_T_object[:3, 3] - places[0]))
        both.append(np.linalg.norm(fused.odom_T_object[:3, 3] - places[0]))

    assert np.median(both) < 0.85 * np.median(alone)


@pytest.mark.requirement("P3")
def test_what_is_left_of_two_calibrations_is_declared_as_it_is():
    rng = np.random.default_rng(6)
    off = []
    for _ in range(300):
        places, first, second = two_views(rng)
        fused = seen_by_all({"a": first, "b": second}).estimates[0]
        off.append(fused.odom_T_object[:3, 3] - places[0])

    declared = np.sqrt(np.diag(fused.error.covariance_m2))
    assert np.std(off, axis=0) == pytest.approx(declared, rel=0.2)
    assert (np.diag(fused.error.shared_m2) < 0.7 * np.diag(COMMON)).all()


def test_a_camera_should_show_what_is_well_within_its_pictures():
    camera = PlacedCamera("ceiling camera", None, poses.transform(poses.rotation_x(np.pi), (0, 0, 2.0)))

    assert camera.should_show(np.array([0.1, 0.1, 0.8]))
    assert not camera.should_show(np.array([2.0, 0.0, 0.8]))
    assert not camera.should_show(np.array([0.0, 0.0, 1.9]))


def test_without_declared_errors_the_first_camera_counts():
    first = cup((0, 0, 0), error=False)
    seen = seen_by_all({"a": [first], "b": [replace(first, odom_T_object=poses.translation(0.02, 0, 0))]})

    assert seen.estimates == (first,)
