"""The certificate stands on three bounds; each is tried against the thing that it bounds."""

import dataclasses

import coal
import numpy as np
import pinocchio as pin
import pytest

from kinematics.checking.coal_certificate import CollisionCheck
from kinematics.checking.compiled_kinematics import CompiledKinematics
from kinematics.checking.contacts import ContactFinder
from kinematics.checking.kinematics import BatchedKinematics
from kinematics.checking.limits import jump_intervals
from kinematics.checking.pairs import PairBuilder
from kinematics.checking.settings import CheckSettings
from kinematics.checking.solids import distance_to_shape
from kinematics.checking.timeline import Timeline
from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball, Box, Cylinder
from kinematics.motion.trajectory import Trajectory
from kinematics.scene.planning_scene import PlanningScene, SceneObject


@pytest.fixture(scope="module", params=[BatchedKinematics, CompiledKinematics])
def kinematics(talos, request):
    return request.param(talos)


def wild_trajectory(talos, stance, seed, samples=12):
    """Positions and velocities of samples drawn apart: cubics that bow in every way."""
    rng = np.random.default_rng(seed)
    t = np.concatenate([[0.0], np.cumsum(rng.uniform(0.002, 0.2, samples - 1))])
    q = np.tile(talos.q_home, (samples, 1)) + rng.normal(0.0, 0.2, (samples, talos.nq))
    q[:, 3:7] /= np.linalg.norm(q[:, 3:7], axis=1, keepdims=True)
    return Trajectory(talos.joints, stance, t, q, rng.normal(0.0, 2.0, (samples, talos.nv)))


@pytest.fixture(scope="module")
def scene(talos):
    gripper = talos.description.grippers["left"]
    held = SceneObject("held", Cylinder(0.03, 0.2), np.eye(4))
    things = [
        SceneObject("box", Box((0.2, 0.3, 0.1)), poses.transform(poses.rotation_x(0.4), (0.6, 0.1, 0.9))),
        SceneObject("pole", Cylinder(0.02, 0.8), poses.transform(poses.rotation_y(1.0), (0.5, -0.3, 1.0))),
        SceneObject("ball", Ball(0.07), poses.translation(0.4, 0.4, 1.2)),
    ]
    scene = PlanningScene().with_objects([held, *things])
    return scene.with_attached("held", gripper.tcp_frame, poses.translation(0, 0.02, 0), gripper.touch_links)


@pytest.mark.parametrize("seed", range(5))
def test_batched_kinematics_agree_with_pinocchio(talos, stance, kinematics, seed):
    timeline = Timeline(wild_trajectory(talos, stance, seed))
    at = timeline.at(np.linspace(0.0, timeline.duration_s, 7))
    placed, com = kinematics.poses(at), None
    com = kinematics.com(placed)
    data = talos.pin.createData()
    for i in range(7):
        q = np.concatenate([at.base_position_m[i], at.base_quaternion[i], at.joints_rad[i]])
        assert com[i] == pytest.approx(np.array(pin.centerOfMass(talos.pin, data, q)), abs=1e-9)
        for body in range(1, talos.pin.njoints):
            assert np.allclose(placed.rotation[body, i], data.oMi[body].rotation, atol=1e-9)
            assert np.allclose(placed.origin_m[body, i], data.oMi[body].translation, atol=1e-9)


@pytest.mark.parametrize("seed", range(5))
def test_nothing_moves_farther_than_its_path_length(talos, stance, seed):
    timeline = Timeline(wild_trajectory(talos, stance, seed))
    knots = timeline.knots(0.05)
    lengths = timeline.path_lengths(knots)
    for i in range(len(knots) - 1):
        fine = timeline.at(np.linspace(knots[i], knots[i + 1], 40))
        steps = np.abs(np.diff(fine.joints_rad, axis=0)).sum(axis=0)
        assert (steps <= lengths[i, 2:] + 1e-12).all()
        assert np.linalg.norm(np.diff(fine.base_position_m, axis=0), axis=1).sum() <= lengths[i, 0] + 1e-12
        turn = poses.angle_between(fine.base_rotation[0], fine.base_rotation[-1])
        assert turn <= lengths[i, 1] + 1e-9


@pytest.mark.parametrize("seed", range(8))
def test_no_pair_comes_closer_than_its_rates_allow(talos, stance, kinematics, scene, seed):
    pairs = PairBuilder(talos, kinematics).pairs(scene)
    timeline = Timeline(wild_trajectory(talos, stance, seed))
    ends = np.array([0.0, 0.5, 1.0]) * timeline.duration_s
    placed = kinematics.poses(timeline.at(ends))
    bound = timeline.path_lengths(ends) @ pairs.rate
    rng = np.random.default_rng(seed)
    for pair in rng.choice(len(pairs.first), 120, replace=False):
        first, second = pairs.solids[pairs.first[pair]], pairs.solids[pairs.second[pair]]
        gaps = []
        for i in range(3):
            places = []
            for solid in (first, second):
                body = poses.transform(placed.rotation[solid.body, i], placed.origin_m[solid.body, i])
                place = body @ solid.body_T_solid
                places.append(coal.Transform3s(place[:3, :3], place[:3, 3]))
            request, result = coal.DistanceRequest(), coal.DistanceResult()
            gaps.append(coal.distance(first.geometry, places[0], second.geometry, places[1], request, result))
        assert (np.abs(np.diff(gaps)) <= bound[:, pair] + 1e-6).all()


@pytest.mark.parametrize("seed", range(4))
def test_balls_and_planes_never_promise_more_than_the_exact_distance(talos, stance, kinematics, scene, seed):
    pairs = PairBuilder(talos, kinematics).pairs(scene)
    check = CollisionCheck(
        kinematics,
        Timeline(wild_trajectory(talos, stance, seed)),
        pairs,
        CheckSettings(cell_s=0.1),
        np.empty((0, 2)),
    )
    knots = check._timeline.knots(0.05)
    level = check._level(knots[:-2:2], knots[2::2])
    cells = np.arange(len(level.middles_s))
    balls = check._ball_distances(level, cells, np.arange(len(pairs.first)))
    rng = np.random.default_rng(seed)
    for pair in rng.choice(len(pairs.first), 60, replace=False):
        exact = [check._exact(level, int(pair), int(cell)) for cell in cells]
        distances = np.array([distance for distance, _ in exact])
        outside = np.maximum(distances, 0.0)
        assert (balls[:, pair] <= outside + 1e-6).all()
        seen = int(np.argmax(distances))
        if distances[seen] <= 0.0:
            continue
        planes = check._plane_distances(level, int(pair), cells, exact[seen][1], seen)
        assert (planes <= outside + 1e-6).all()
        assert planes[seen] == pytest.approx(distances[seen], abs=1e-4)


@pytest.mark.parametrize(
    ("shape", "solid"),
    [
        (Box((0.2, 0.4, 0.6)), coal.Box(0.2, 0.4, 0.6)),
        (Cylinder(0.1, 0.5), coal.Cylinder(0.1, 0.5)),
        (Ball(0.2), coal.Sphere(0.2)),
    ],
)
def test_the_distance_to_a_shape_is_coals(shape, solid):
    points = np.random.default_rng(0).uniform(-1.0, 1.0, (60, 3))
    here = coal.Transform3s()
    for point, distance in zip(points, distance_to_shape(shape, points), strict=True):
        request, result = coal.DistanceRequest(), coal.DistanceResult()
        request.enable_signed_distance = True
        there = coal.Transform3s(np.eye(3), point)
        exact = coal.distance(solid, here, coal.Sphere(1e-6), there, request, result)
        assert distance == pytest.approx(max(exact, 0.0), abs=1e-5)


def test_jumps_are_looked_at_but_not_refined(talos, stance, kinematics, scene):
    """A jump of twelve radians is a finding already; proving what lies in between took minutes."""
    trajectory = wild_trajectory(talos, stance, 0)
    q = trajectory.q.copy()
    q[len(q) // 2 :, 7:] += 12.0
    timeline = Timeline(dataclasses.replace(trajectory, q=q))
    settings = CheckSettings()
    jumps_s = jump_intervals(talos, timeline, settings)
    pairs = PairBuilder(talos, kinematics).pairs(scene)

    judges = [CollisionCheck(kinematics, timeline, pairs, settings, s) for s in (jumps_s, np.empty((0, 2)))]
    found = [{finding.subject for finding in judge.findings()} for judge in judges]

    assert len(jumps_s) >= 1
    assert found[0] <= found[1]
    assert judges[0].queries < 0.5 * judges[1].queries


@pytest.mark.requirement("S6")
@pytest.mark.parametrize("seed", range(6))
def test_no_look_of_coals_contradicts_the_compiled_certificate(talos, stance, scene, seed):
    """Cubics that bow in every way, some of whose pairs touch: nothing touches before it is said to."""
    kinematics = CompiledKinematics(talos)
    builder, settings = PairBuilder(talos, kinematics), CheckSettings()
    pairs = builder.pairs(scene)
    timeline = Timeline(wild_trajectory(talos, stance, seed, samples=4))
    findings, _ = ContactFinder(kinematics, builder.robot, settings).findings(
        timeline, pairs, np.empty((0, 2))
    )
    first_s = {finding.subject: finding.t_s for finding in findings}
    times = np.linspace(0.0, timeline.duration_s, 150)
    placed = kinematics.poses(timeline.at(times))
    rng = np.random.default_rng(seed)
    request = coal.DistanceRequest()
    request.enable_signed_distance = True
    assert findings
    for pair in rng.choice(len(pairs.first), 120, replace=False):
        two = [pairs.solids[side[pair]] for side in (pairs.first, pairs.second)]
        until = first_s.get((two[0].name, two[1].name), np.inf)
        for i in np.flatnonzero(times < until - 1e-9):
            places = [
                poses.transform(placed.rotation[solid.body, i], placed.origin_m[solid.body, i])
                @ solid.body_T_solid
                for solid in two
            ]
            there = [coal.Transform3s(place[:3, :3], place[:3, 3]) for place in places]
            gap = coal.distance(
                two[0].geometry, there[0], two[1].geometry, there[1], request, coal.DistanceResult()
            )
            assert gap > pairs.clearance_m[pair] - 1e-6, (two[0].name, two[1].name, times[i])
