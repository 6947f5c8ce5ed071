"""Several frames become one estimate for each thing."""

import math

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball, Box, Cylinder
from robots.perception.detector import Detection, PerceptionFrame
from robots.perception.object_estimate import fuse_frames

CUP = Cylinder(0.03, 0.11)
CAMERA = poses.transform(
    poses.rotation_z(0.3)
    @ np.array([[0.0, -0.5, math.sqrt(0.75)], [-1.0, 0.0, 0.0], [0.0, -math.sqrt(0.75), -0.5]]),
    (0.1, 0.0, 1.5),
)


def detection(odom_T_object, kind="cup", color="red", shape=CUP, category="object", confidence=0.9):
    return Detection(category, kind, color, poses.inverse(CAMERA) @ odom_T_object, shape, confidence)


def views(*frames):
    return [(CAMERA, PerceptionFrame(0.03 * k, k, tuple(frame))) for k, frame in enumerate(frames)]


def at(x, y=0.0, z=0.9, rotation=None):
    return poses.transform(np.eye(3) if rotation is None else rotation, (x, y, z))


def noisy(rng, pose, sigma=0.002, turn=0.005):
    pose = pose.copy()
    pose[:3, 3] += rng.normal(0.0, sigma, 3)
    pose[:3, :3] = pose[:3, :3] @ poses.rotation_from_vector(rng.normal(0.0, turn, 3))
    return pose


def test_averaging_frames_beats_the_noise_of_one_frame():
    rng = np.random.default_rng(1)
    errors = []
    for _ in range(100):
        (cup,) = fuse_frames(views(*[[detection(noisy(rng, at(0.5)))] for _ in range(8)]))
        errors.append(np.linalg.norm(cup.odom_T_object[:3, 3] - (0.5, 0.0, 0.9)))

    assert np.sqrt(np.mean(np.square(errors))) < 1.2 * 0.002 * math.sqrt(3 / 8)


def test_what_stands_is_vertical_and_what_lies_keeps_its_tilt():
    leaning = at(0.5, rotation=poses.rotation_x(0.1))
    tipped = at(0.5, 0.3, rotation=poses.rotation_x(1.5))

    lying, standing = sorted(
        fuse_frames(views(*[[detection(leaning), detection(tipped)]] * 4)), key=lambda cup: -cup.tilt_rad
    )

    assert not standing.lying
    np.testing.assert_allclose(standing.odom_T_object[:3, :3], np.eye(3), atol=1e-12)
    assert lying.lying
    assert lying.tilt_rad == pytest.approx(1.5, abs=1e-6)


def test_a_knob_is_turned_as_it_is_seen_also_where_that_is_little():
    knob = Box((0.04, 0.06, 0.024))
    turned = detection(at(0.5, rotation=poses.rotation_x(0.3)), "knob", None, knob, "furniture")

    (seen,) = fuse_frames(views(*[[turned]] * 4))

    np.testing.assert_allclose(seen.odom_T_object[:3, :3], poses.rotation_x(0.3), atol=1e-9)


def test_a_box_keeps_its_heading_and_a_ball_has_none():
    turned = poses.rotation_z(0.7) @ poses.rotation_x(0.05)
    box = detection(at(0.5, rotation=turned), "box", "blue", Box((0.05, 0.1, 0.1)))
    ball = detection(at(0.5, 0.3, rotation=poses.rotation_x(2.0)), "ball", "red", Ball(0.03))

    found = {e.kind: e for e in fuse_frames(views(*[[box, ball]] * 4))}

    assert poses.yaw_of(found["box"].odom_T_object[:3, :3]) == pytest.approx(0.7, abs=0.01)
    assert found["box"].odom_T_object[2, 2] == pytest.approx(1.0)
    assert not found["ball"].lying


def test_the_heading_of_a_box_is_the_mean_of_its_frames():
    crate = Box((0.2, 0.1, 0.1))
    turns = (0.30, 0.34, 0.41)

    (box,) = fuse_frames(
        views(*[[detection(at(0.5, rotation=poses.rotation_z(a)), "box", shape=crate)] for a in turns])
    )

    assert poses.yaw_of(box.odom_T_object[:3, :3]) == pytest.approx(0.35, abs=1e-4)


def test_a_false_detection_is_dropped_and_a_real_one_with_gaps_is_kept():
    frames = [[detection(at(0.5))] for _ in range(8)]
    frames[2].append(detection(at(0.6, 0.4), confidence=0.6))
    frames[5].append(detection(at(0.4, -0.3), confidence=0.6))
    frames[3] = frames[6] = []

    (cup,) = fuse_frames(views(*frames))

    assert cup.frames_seen == 6


def test_a_merged_detection_does_not_pull_but_shows_in_the_spread():
    rng = np.random.default_rng(0)
    clean = [[detection(noisy(rng, at(0.5)))] for _ in range(8)]
    merged = [*clean[:7], [detection(at(0.5, 0.026), shape=Cylinder(0.06, 0.11))]]

    (plain,), (pulled,) = fuse_frames(views(*clean)), fuse_frames(views(*merged))

    assert np.linalg.norm(pulled.odom_T_object[:3, 3] - (0.5, 0, 0.9)) < 0.003
    assert pulled.shape.radius_m == pytest.approx(0.03)
    assert pulled.spread_m > 0.008 > 0.005 > plain.spread_m
    assert pulled.confidence < plain.confidence


def test_two_equal_cups_that_nearly_touch_stay_two():
    rng = np.random.default_rng(0)
    cup = Cylinder(0.02, 0.1)
    pair = [at(0.5, 0.0), at(0.5, 0.041)]

    found = fuse_frames(views(*[[detection(noisy(rng, p), shape=cup) for p in pair] for _ in range(8)]))

    assert [round(float(e.odom_T_object[1, 3]), 2) for e in found] == [0.0, 0.04]


def test_a_thing_is_counted_at_most_once_a_frame():
    frames = [[detection(at(0.5))], *[[detection(at(0.5)), detection(at(0.525))] for _ in range(7)]]

    assert [cup.frames_seen for cup in fuse_frames(views(*frames))] == [8, 7]


def test_an_unknown_colour_joins_the_known_one_and_another_colour_does_not():
    near, far = at(0.5), at(0.5, 0.2)
    frames = [
        [detection(near, color="red" if k % 2 else None), detection(far, color="blue")] for k in range(6)
    ]

    assert [(e.color, e.frames_seen) for e in fuse_frames(views(*frames))] == [("blue", 6), ("red", 6)]


def test_a_thing_named_in_two_ways_at_one_place_is_one_thing():
    frames = [[detection(at(0.5), color="red" if k % 3 else "orange")] for k in range(9)]

    (cup,) = fuse_frames(views(*frames))

    assert cup.color == "red"


def test_furniture_solids_are_kept_apart():
    top = detection(at(0.6, z=0.8), "table", None, Box((0.6, 1.2, 0.03)), "furniture")
    legs = [
        detection(at(0.6 + x, y, 0.4), "table", None, Box((0.05, 0.05, 0.77)), "furniture")
        for x in (-0.25, 0.25)
        for y in (-0.55, 0.55)
    ]

    assert len(fuse_frames(views(*[[top, *legs]] * 4))) == 5


def test_a_frame_given_twice_counts_once():
    view = views([detection(at(0.5))])

    (cup,) = fuse_frames(view * 5)

    assert cup.frames_seen == 1


def test_nothing_seen_is_nothing_estimated():
    assert fuse_frames(()) == ()
    assert fuse_frames(views([], [], [])) == ()


def test_the_order_of_detections_in_a_frame_does_not_matter():
    rng = np.random.default_rng(2)
    frames = [[detection(noisy(rng, at(0.5 + 0.1 * i))) for i in range(4)] for _ in range(6)]

    forward = fuse_frames(views(*frames))
    backward = fuse_frames(views(*[frame[::-1] for frame in frames]))

    assert [e.odom_T_object.tobytes() for e in forward] == [e.odom_T_object.tobytes() for e in backward]


def test_what_stands_in_the_middle_of_a_box_is_seen_as_well_as_the_box():
    box = detection(at(0.5), "box", "brown", Box((0.18, 0.15, 0.1)))
    cup = detection(at(0.505, z=0.905))

    seen = fuse_frames(views(*[[box, cup]] * 4))

    assert [estimate.kind for estimate in seen] == ["box", "cup"]


BASKET = Box((0.170, 0.157, 0.141))
MUG = Cylinder(0.063, 0.133)


def test_a_mug_that_barely_goes_into_a_basket_is_seen_in_it_where_both_are_told_at_once():
    basket, mug = detection(at(0.5), "basket", "white", BASKET), detection(at(0.505), shape=MUG)

    seen = fuse_frames(views(*[[basket, mug]] * 4, [basket], [mug]))

    assert [estimate.kind for estimate in seen] == ["basket", "cup"]


def test_what_is_told_in_turn_to_be_a_mug_and_a_basket_is_one_of_them():
    basket, mug = detection(at(0.5), "basket", "white", BASKET), detection(at(0.505), shape=MUG)

    (seen,) = fuse_frames(views(*[[basket]] * 5, *[[mug]] * 3))

    assert seen.kind == "basket"


@pytest.mark.parametrize("wider", [1.0, 1.03, 1.1])
def test_what_is_told_twice_at_once_is_of_one_size_and_one_thing(wider):
    other = detection(at(0.505), "can", shape=Cylinder(wider * CUP.radius_m, CUP.height_m))

    assert len(fuse_frames(views(*[[detection(at(0.5)), other]] * 5))) == 1


def test_one_thing_that_is_named_in_two_ways_is_one():
    frames = [[detection(at(0.5))]] * 5 + [[detection(at(0.505), "can")]] * 3

    (seen,) = fuse_frames(views(*frames))

    assert seen.kind == "cup"


@pytest.mark.requirement("P2")
def test_a_narrow_box_that_flickers_where_a_cup_is_seen_is_not_in_the_cup():
    box = detection(at(0.505), "box", shape=Box((0.031, 0.045, 0.108)), confidence=0.4)
    frames = [[detection(at(0.5), shape=Cylinder(0.026, 0.108))]] * 3 + [[box]] * 3

    (seen,) = fuse_frames(views(*frames))

    assert seen.kind == "cup"


def test_a_name_that_few_frames_are_sure_of_is_what_a_thing_may_be():
    frames = [
        (np.eye(4), PerceptionFrame(0.1 * k, k, (_unsure(names, alike),)))
        for k, (names, alike) in enumerate([((), ("soup",)), (("soup",), ()), ((), ("soup",))])
    ]

    (estimate,) = fuse_frames(frames)

    assert (estimate.names, estimate.alike) == ((), ("soup",))
    assert estimate.label.alike == ("soup",)


def _unsure(names, alike):
    pose = poses.translation(0.0, 0.0, 1.0)
    return Detection("object", "can", "red", pose, Cylinder(0.03, 0.1), 0.9, names=names, alike=alike)


@pytest.mark.requirement("P2")
def test_a_box_whose_sides_are_named_in_turn_is_as_it_is_seen_each_time():
    rng = np.random.default_rng(5)
    frames = []
    for k in range(6):
        quarters, size = (k % 4, (0.05, 0.08, 0.1) if k % 2 == 0 else (0.08, 0.05, 0.1))
        turned = poses.rotation_z(0.7 + 0.5 * math.pi * quarters)
        frames.append([detection(noisy(rng, at(0.5, rotation=turned)), "box", "blue", Box(size))])

    (box,) = fuse_frames(views(*frames))

    assert box.shape == Box((0.05, 0.08, 0.1))
    assert poses.yaw_of(box.odom_T_object[:3, :3]) == pytest.approx(0.7, abs=0.02)
