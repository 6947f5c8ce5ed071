"""The perception stub: a declared, seeded error model, and nothing else, between truth and detections."""

import math
from dataclasses import replace

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball, Box, Cylinder
from kinematics.model.camera_description import CameraDescription
from kinematics.scene.known_part import KnownPart
from robots.clock import ManualClock
from robots.perception.stub import PerceptionStub
from robots.perception.truth_view import TrueObject
from robots.scenes.scene_description import PerceptionModel

CAMERA = CameraDescription(
    frame="camera", horizontal_fov_rad=1.05, vertical_fov_rad=0.86, range_m=(0.3, 4.0),
    pan_joint="pan", tilt_joint="tilt",
)  # fmt: skip
EXACT = PerceptionModel(
    bias_m=0.0, noise_m=0.0, orientation_noise_rad=0.0, size_noise=0.0, dropout=0.0,
    false_rate=0.0, merge_chance=0.0,
)  # fmt: skip
# optical axis along the world's x: z forward, x right, y down
FORWARD = np.array([[0.0, 0.0, 1.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0]])
CUP = Cylinder(0.03, 0.11)


class ScriptedTruth:
    """A world of scripted solids; ``hidden`` names what nothing of can be seen."""

    def __init__(self, *solids):
        self.objects = list(solids)
        self.hidden = {}
        self.camera = poses.transform(FORWARD, (0.0, 0.0, 1.0))

    def solids(self):
        return tuple(self.objects)

    def world_T_camera(self):
        return self.camera

    def visible(self, name, points):
        share = 1.0 - self.hidden.get(name, 0.0)
        return np.arange(len(points)) < round(share * len(points))


def thing(name="red cup", place=(1.0, 0.0, 1.0), kind="cup", color="red", shape=CUP, category="object"):
    return TrueObject(name, category, kind, color, shape, poses.translation(*place))


class Bench:
    """A stub over a scripted truth, with its clock."""

    def __init__(self, *solids, model=EXACT, seed=0):
        self.truth = ScriptedTruth(*solids)
        self.clock = ManualClock()
        self.stub = PerceptionStub(self.truth, CAMERA, model, self.clock, np.random.default_rng(seed))

    def run(self, seconds):
        """Advance in control periods and collect the frames as they are delivered."""
        frames = []
        for _ in range(round(seconds / 0.002)):
            self.stub.tick()
            frame = self.stub.latest()
            if frame is not None and (not frames or frame is not frames[-1][1]):
                frames.append((self.clock.now_s(), frame))
            self.clock.advance(0.002)
        return frames

    def frames(self, seconds):
        return [frame for _, frame in self.run(seconds)]

    def world(self, detection):
        return self.truth.camera @ detection.camera_T_object


def positions(bench, frames):
    return np.array([bench.world(d)[:3, 3] for frame in frames for d in frame.detections])


@pytest.mark.requirement("P1")
def test_without_errors_the_stub_tells_the_truth():
    bench = Bench(thing())

    (detection,) = bench.frames(0.2)[-1].detections

    assert (detection.kind, detection.color, detection.shape) == ("cup", "red", CUP)
    np.testing.assert_allclose(bench.world(detection), poses.translation(1.0, 0.0, 1.0), atol=1e-12)


@pytest.mark.requirement("P1")
def test_frames_come_at_the_rate_and_after_the_latency():
    bench = Bench(thing(), model=replace(EXACT, rate_hz=25.0, latency_s=0.1))

    arrivals = bench.run(2.0)

    assert len(arrivals) == pytest.approx((2.0 - 0.1) * 25.0, abs=1)
    assert [frame.sequence for _, frame in arrivals] == list(range(len(arrivals)))
    for at_s, frame in arrivals:
        assert at_s - frame.stamp_s == pytest.approx(0.1, abs=0.0021)
    np.testing.assert_allclose(np.diff([frame.stamp_s for _, frame in arrivals]), 0.04, atol=1e-9)


@pytest.mark.requirement("P1")
def test_the_bias_is_drawn_once_an_episode_and_has_the_declared_deviation():
    model = replace(EXACT, bias_m=0.005)
    biases = []
    for seed in range(400):
        bench = Bench(thing(), model=model, seed=seed)
        seen = positions(bench, bench.frames(0.2))
        np.testing.assert_allclose(seen, seen[:1].repeat(len(seen), axis=0), atol=1e-12)
        biases.append(seen[0] - (1.0, 0.0, 1.0))

    assert np.std(biases, axis=0) == pytest.approx(0.005, rel=0.12)
    assert np.abs(np.mean(biases, axis=0)).max() < 3 * 0.005 / math.sqrt(400)


@pytest.mark.requirement("P1")
def test_the_noise_of_frames_has_the_declared_deviation():
    bench = Bench(thing(), model=replace(EXACT, noise_m=0.002, orientation_noise_rad=0.01))

    frames = bench.frames(20.0)

    assert np.std(positions(bench, frames), axis=0) == pytest.approx(0.002, rel=0.12)
    turns = [poses.vector_from_rotation(bench.world(f.detections[0])[:3, :3]) for f in frames]
    assert np.std(turns, axis=0) == pytest.approx(0.01, rel=0.12)


@pytest.mark.requirement("P1")
def test_sizes_are_wrong_by_one_factor_an_episode():
    model = replace(EXACT, size_noise=0.02)
    factors = []
    for seed in range(300):
        frames = Bench(thing(), model=model, seed=seed).frames(0.15)
        assert len({f.detections[0].shape for f in frames}) == 1
        factors.append(frames[0].detections[0].shape.radius_m / CUP.radius_m)

    assert np.std(factors) == pytest.approx(0.02, rel=0.15)


@pytest.mark.requirement("P1")
def test_dropout_loses_the_declared_share_of_detections():
    frames = Bench(thing(), model=replace(EXACT, dropout=0.2)).frames(40.0)

    missing = np.mean([not frame.detections for frame in frames])

    assert missing == pytest.approx(0.2, abs=0.04)


@pytest.mark.requirement("P1")
def test_false_detections_come_at_their_rate_inside_the_view():
    bench = Bench(model=replace(EXACT, false_rate=0.5))

    frames = bench.frames(20.0)

    false = [d for frame in frames for d in frame.detections]
    assert len(false) / len(frames) == pytest.approx(0.5, rel=0.2)
    for detection in false:
        x, y, z = detection.camera_T_object[:3, 3]
        assert abs(x / z) <= math.tan(0.525)
        assert abs(y / z) <= math.tan(0.43)
        np.testing.assert_allclose(bench.world(detection)[:3, 2], (0, 0, 1), atol=1e-9)


@pytest.mark.requirement("P1")
def test_nearly_touching_objects_are_merged_by_chance_and_others_never():
    near = [thing("a", (1.0, 0.0, 1.0)), thing("b", (1.0, 0.062, 1.0))]
    apart = [thing("a", (1.0, 0.0, 1.0)), thing("b", (1.0, 0.08, 1.0))]
    model = replace(EXACT, merge_chance=0.3)

    merged = [f for f in Bench(*near, model=model).frames(20.0) if len(f.detections) == 1]
    separate = Bench(*apart, model=model).frames(5.0)

    assert len(merged) / 600 == pytest.approx(0.3, abs=0.06)
    assert merged[0].detections[0].shape.radius_m == pytest.approx(0.061)
    assert all(len(frame.detections) == 2 for frame in separate)


@pytest.mark.requirement("P1")
@pytest.mark.parametrize(
    "place",
    [(0.25, 0.0, 1.0), (4.5, 0.0, 1.0), (1.0, 0.7, 1.0), (1.0, 0.0, 1.7), (-1.0, 0.0, 1.0)],
    ids=["too near", "too far", "left of the view", "above the view", "behind"],
)
def test_what_is_outside_field_of_view_or_range_is_not_seen(place):
    assert not Bench(thing(place=place)).frames(0.2)[-1].detections


@pytest.mark.requirement("P1")
def test_an_object_mostly_hidden_is_not_seen_and_one_partly_hidden_with_less_confidence():
    bench = Bench(thing())
    confidence = {}
    for hidden in (0.0, 0.5, 0.8):
        bench.truth.hidden["red cup"] = hidden
        confidence[hidden] = [d.confidence for f in bench.frames(0.5)[3:] for d in f.detections]

    assert not confidence[0.8]
    assert np.mean(confidence[0.5]) < np.mean(confidence[0.0]) - 0.1


def test_confidence_falls_with_distance_and_towards_the_edge_of_the_view():
    def confidence(place):
        return np.mean([f.detections[0].confidence for f in Bench(thing(place=place)).frames(1.0)])

    assert confidence((3.0, 0.0, 1.0)) < confidence((1.0, 0.0, 1.0)) - 0.05
    assert confidence((1.0, 0.5, 1.0)) < confidence((1.0, 0.0, 1.0)) - 0.03


@pytest.mark.requirement("P1")
def test_furniture_recognised_by_its_top_is_told_with_all_its_solids():
    top = thing("table/top", (1.0, 0.0, 0.8), "table", None, Box((0.6, 1.2, 0.03)), "furniture")
    leg = thing("table/leg 1", (0.75, 0.5, 0.4), "table", None, Box((0.05, 0.05, 0.77)), "furniture")
    bench = Bench(top, leg, model=replace(EXACT, bias_m=0.005))
    bench.truth.hidden["table/leg 1"] = 1.0

    seen = bench.frames(0.2)[-1].detections

    assert [d.category for d in seen] == ["furniture", "furniture"]
    errors = [bench.world(d)[:3, 3] - s.world_T_object[:3, 3] for d, s in zip(seen, (top, leg), strict=True)]
    np.testing.assert_allclose(errors[0], errors[1], atol=1e-12)


@pytest.mark.requirement("P1")
def test_the_same_seed_tells_the_same_and_another_seed_something_else():
    def told(seed):
        bench = Bench(
            thing(),
            thing("ball", (1.2, 0.3, 1.0), "ball", "blue", Ball(0.04)),
            model=PerceptionModel(),
            seed=seed,
        )
        return [
            (d.kind, d.camera_T_object.tobytes(), d.shape, d.confidence)
            for frame in bench.frames(2.0)
            for d in frame.detections
        ]

    assert told(3) == told(3)
    assert told(3) != told(4)


def test_a_blind_stub_delivers_empty_frames_and_sees_again_afterwards():
    bench = Bench(thing())
    bench.stub.faults.blind = True
    assert not any(frame.detections for frame in bench.frames(0.3))

    bench.stub.faults.clear()

    assert bench.frames(0.3)[-1].detections


def test_a_wrong_colour_is_told_of_one_kind_only():
    bench = Bench(thing(), thing("ball", (1.2, 0.3, 1.0), "ball", "blue", Ball(0.04)))
    bench.stub.faults.recolor("cup", "green")

    colors = {d.kind: d.color for d in bench.frames(0.2)[-1].detections}

    assert colors == {"cup": "green", "ball": "blue"}


class TestFirstLookError:
    OFFSET = (0.0, 0.04, 0.0)

    def errors(self, bench, seconds):
        return positions(bench, bench.frames(seconds)) - (1.0, 0.0, 1.0)

    def test_it_lasts_a_second_from_the_first_frame_at_rest(self):
        bench = Bench(thing())
        bench.stub.set_error("cup", self.OFFSET)

        errors = self.errors(bench, 2.0)

        wrong = int(np.sum(errors[:, 1] > 0.03))
        assert wrong == pytest.approx(31, abs=2)
        np.testing.assert_allclose(errors[:wrong], np.tile(self.OFFSET, (wrong, 1)), atol=1e-12)
        np.testing.assert_allclose(errors[wrong:], 0.0, atol=1e-12)

    def test_it_ends_when_the_camera_has_turned_by_more_than_two_degrees(self):
        bench = Bench(thing())
        bench.stub.set_error("cup", self.OFFSET)
        assert self.errors(bench, 0.3)[-1, 1] == pytest.approx(0.04)

        bench.truth.camera = poses.transform(poses.rotation_z(0.05) @ FORWARD, (0.0, 0.0, 1.0))
        bench.frames(0.1)

        assert self.errors(bench, 0.2)[-1, 1] == pytest.approx(0.0, abs=1e-12)

    def test_it_outlasts_the_turn_of_the_head_towards_the_object(self):
        bench = Bench(thing())
        bench.stub.set_error("cup", self.OFFSET)
        for k in range(600):
            turn = poses.rotation_z(0.3 - 0.0005 * k)
            bench.truth.camera = poses.transform(turn @ FORWARD, (0.0, 0.0, 1.0))
            bench.run(0.002)

        assert self.errors(bench, 0.3)[-1, 1] == pytest.approx(0.04)

    def test_it_stays_when_it_is_asked_to(self):
        bench = Bench(thing())
        bench.stub.set_error("cup", self.OFFSET, first_look_only=False)

        assert self.errors(bench, 3.0)[-1, 1] == pytest.approx(0.04)


def test_no_pictures_are_taken_while_nobody_looks_and_fresh_ones_when_somebody_does():
    bench = Bench(thing())
    bench.truth.asked = 0

    def counted(name, points):
        bench.truth.asked += 1
        return np.ones(len(points), dtype=bool)

    bench.truth.visible = counted
    for _ in range(5000):
        bench.clock.advance(0.002)
        bench.stub.tick()
    idle = bench.truth.asked
    began_s = bench.clock.now_s()
    bench.stub.latest()
    for _ in range(100):
        bench.clock.advance(0.002)
        bench.stub.tick()

    assert idle <= 0.5 * EXACT.rate_hz + 1
    assert bench.stub.latest().stamp_s >= began_s


@pytest.mark.requirement("P1")
@pytest.mark.parametrize(("far_m", "worse"), [(3.9, 1.0), (8.0, 4.0)])
def test_noise_grows_with_the_square_of_the_distance_beyond_four_metres(far_m, worse):
    bench = Bench(thing(place=(far_m, 0.0, 1.0)), model=replace(EXACT, noise_m=0.002))
    camera = replace(CAMERA, range_m=(0.3, 10.0))
    bench.stub = PerceptionStub(
        bench.truth, camera, replace(EXACT, noise_m=0.002), bench.clock, np.random.default_rng(3)
    )

    frames = bench.frames(15.0)

    assert np.std(positions(bench, frames), axis=0) == pytest.approx(0.002 * worse, rel=0.15)


@pytest.mark.requirement("P3")
def test_what_is_told_declares_the_error_of_the_model():
    bench = Bench(thing(), model=replace(EXACT, bias_m=0.004, noise_m=0.001, size_noise=0.02))
    ((_, frame), *_) = bench.run(0.2)
    error = frame.detections[0].error

    np.testing.assert_allclose(error.lasting_m2, 0.004**2 * np.eye(3))
    np.testing.assert_allclose(error.noise_m2, 0.001**2 * np.eye(3))
    assert error.size_share == 0.02


def test_a_thing_can_be_told_in_a_wrong_size():
    bench = Bench(thing())
    bench.stub.faults.resize("cup", (4.0 / 3.0, 4.0 / 3.0, 1.0))
    ((_, frame), *_) = bench.run(0.2)

    assert frame.detections[0].shape.radius_m == pytest.approx(0.04)
    assert frame.detections[0].shape.height_m == pytest.approx(0.11)


def test_a_camera_that_is_mounted_otherwise_tells_everything_turned():
    bench = Bench(thing())
    bench.stub.faults.turn_camera((0.0, math.radians(2.0), 0.0))
    ((_, frame), *_) = bench.run(0.2)

    assert frame.detections[0].camera_T_object[0, 3] == pytest.approx(math.sin(math.radians(2.0)))


def test_a_frozen_camera_tells_the_same_with_new_numbers():
    bench = Bench(thing(), model=replace(EXACT, noise_m=0.002))
    bench.run(0.2)
    bench.stub.faults.frozen = True
    frames = [frame for _, frame in bench.run(0.3)][2:]

    assert len({frame.sequence for frame in frames}) == len(frames) > 3
    assert all(frame.detections == frames[0].detections for frame in frames)


def test_a_table_can_be_told_at_a_wrong_height():
    table = thing("table", (1.0, 0.0, 0.8), "table", None, Box((0.6, 1.0, 0.04)), "furniture")
    bench = Bench(table)
    bench.stub.set_error("table", (0.0, 0.0, 0.012), first_look_only=False)
    ((_, frame), *_) = bench.run(0.2)
    height_m = (bench.truth.world_T_camera() @ frame.detections[0].camera_T_object)[2, 3]

    assert height_m == pytest.approx(0.812)


@pytest.mark.requirement("P3")
def test_a_calibration_is_wrong_for_everything_alike_and_declared_as_that():
    model = replace(EXACT, calibration_m=0.005)
    off = []
    for seed in range(40):
        other = thing("ball", (1.2, 0.3, 1.0), "ball", "blue", Ball(0.04))
        bench = Bench(thing(), other, model=model, seed=seed)
        frame = bench.frames(0.2)[-1]
        world = bench.truth.world_T_camera()
        places = {one.kind: (world @ one.camera_T_object)[:3, 3] for one in frame.detections}
        true = {solid.kind: solid.world_T_object[:3, 3] for solid in bench.truth.solids()}
        wrong = [places[kind] - true[kind] for kind in true]
        assert np.allclose(wrong[0], wrong[1])
        assert np.allclose(frame.detections[0].error.shared_m2, 0.005**2 * np.eye(3))
        off.append(wrong[0])

    assert 0.004 < np.std(off) < 0.006


def test_where_a_model_has_a_part_shut_is_as_wrong_as_its_piece_is():
    panel, place = Box((0.02, 0.3, 0.2)), poses.translation(1.2, 0.1, 1.0)
    moves = KnownPart(place, 0.2, "cabinet", "top drawer")
    body = thing("cabinet/top", (1.4, 0.1, 1.1), "fixture", None, Box((0.3, 0.3, 0.02)), "furniture")
    front = replace(
        thing("cabinet/top drawer/front", (1.1, 0.1, 1.0), "drawer", None, panel, "furniture"), moves=moves
    )
    bench = Bench(body, front, model=replace(EXACT, bias_m=0.02), seed=4)
    _, frame = bench.run(0.3)[-1]
    seen = {one.kind: one for one in frame.detections}
    off = bench.truth.camera @ seen["fixture"].camera_T_object[:, 3] - body.world_T_object[:, 3]
    shut = bench.truth.camera @ seen["drawer"].moves.shut

    assert np.linalg.norm(off) > 0.005
    np.testing.assert_allclose(shut[:3, 3], place[:3, 3] + off[:3], atol=1e-9)
