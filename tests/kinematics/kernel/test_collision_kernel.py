from dataclasses import replace

import coal
import numpy as np
import pinocchio as pin
import pytest

from kinematics.collision.collision_world import CollisionWorld
from kinematics.collision.validity import SampledValidity
from kinematics.errors import UnknownNameError
from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball, Box
from kinematics.kernel import door
from kinematics.kernel.collision_kernel import CollisionKernel
from kinematics.kernel.robot_arrays import RobotArrays
from kinematics.model.standing_robot import StandingRobot
from kinematics.scene.planning_scene import PlanningScene, SceneObject


def both(arrays, talos, stance, scene, extra_m=0.004, own_m=0.005):
    kernel = CollisionKernel.standing(arrays, StandingRobot(talos, stance), scene, extra_m, own_m)
    return kernel, CollisionWorld(talos, scene, extra_m, own_m)


def random_edge(rng, talos, space, at_random, length=2.0):
    a = at_random.point(rng, talos, space)
    step = np.zeros(space.size)
    step[[space.index(joint) for joint in talos.description.groups["right_arm"]]] = rng.normal(size=7)
    step[:6] = rng.normal(size=6) * (0.02, 0.02, 0.02, 0.05, 0.05, 0.05)
    return a, a + step * (length / space.distance(np.zeros(space.size), step))


def test_its_coordinates_are_those_of_the_planner(arrays, talos, stance, space, at_random):
    rng = np.random.default_rng(0)
    kernel = CollisionKernel.standing(arrays, StandingRobot(talos, stance), PlanningScene())
    x = np.array([at_random.point(rng, talos, space) for _ in range(100)])
    q, reached = space.to_q(x)

    assert reached.sum() > 50
    for point, expected, reachable in zip(x, q, reached, strict=True):
        found = kernel.configuration(point)
        assert (found is not None) == reachable
        if reachable:
            np.testing.assert_allclose(found, expected, atol=1e-12)


@pytest.mark.parametrize("seed", range(4))
def test_it_agrees_with_coal_on_configurations_amid_clutter(
    seed, arrays, talos, stance, space, make, at_random
):
    rng = np.random.default_rng(seed)
    kernel, world = both(arrays, talos, stance, at_random.scene(rng, talos, make, held=seed % 2 == 1))
    q = space.to_q(np.array([at_random.point(rng, talos, space) for _ in range(150)]))[0]

    ours, theirs = [kernel.collides(c) for c in q], [world.collides(c) for c in q]

    assert 10 < sum(theirs) < 140
    assert ours == theirs


@pytest.mark.parametrize("seed", range(3))
def test_it_agrees_with_the_planner_on_points(seed, arrays, talos, stance, space, make, at_random):
    rng = np.random.default_rng(100 + seed)
    kernel, world = both(arrays, talos, stance, at_random.scene(rng, talos, make))
    sampled = SampledValidity(StandingRobot(talos, stance), world)
    x = [at_random.point(rng, talos, space) for _ in range(150)]

    assert [kernel.is_free(point) for point in x] == [sampled.points_are_free(point[None]) for point in x]


def test_an_edge_that_is_proven_free_is_free_wherever_coal_looks(
    arrays, talos, stance, space, make, at_random
):
    rng = np.random.default_rng(7)
    proven = refused = pessimistic = 0
    for k in range(6):
        kernel, world = both(arrays, talos, stance, at_random.scene(rng, talos, make, held=k % 2 == 1))
        sampled = SampledValidity(StandingRobot(talos, stance), world)
        for _ in range(60):
            a, b = random_edge(rng, talos, space, at_random, length=0.5)
            points = a + (b - a) * np.linspace(0.0, 1.0, 129)[:, None]
            free = kernel.edge_is_free(a, b)
            if free:
                assert sampled.points_are_free(points[::4])
            proven += free
            refused += not free
            pessimistic += not free and kernel.points_are_free(points)
    assert proven > 20
    assert refused > 20
    assert pessimistic <= 0.02 * (proven + refused)


def test_a_thin_rod_between_two_samples_is_found(arrays, talos, stance, space):
    a = space.from_q(talos.q_home)
    b = a.copy()
    b[space.index("arm_right_4_joint")] += 0.6
    middle = space.to_q((a + 0.437 * (b - a))[None])[0][0]
    tip = talos.frame_pose(middle, "gripper_right_fingertip_1_link")
    rod = SceneObject("rod", Box((0.001, 0.4, 0.001)), tip @ poses.translation(0.0, 0.0, 0.0))
    clear = CollisionKernel.standing(arrays, StandingRobot(talos, stance), PlanningScene())
    blocked = CollisionKernel.standing(arrays, StandingRobot(talos, stance), PlanningScene().with_object(rod))

    assert clear.edge_is_free(a, b)
    refusal = blocked.polyline_refusal(np.stack([a, b]))
    assert refusal is not None
    assert refusal.pair is not None
    assert refusal.pair[1] == "rod"


def test_whatever_is_where_a_fingertip_passes_while_the_pelvis_moves_is_found(arrays, talos, stance, space):
    rng = np.random.default_rng(11)
    found = 0
    for k in range(60):
        a = space.from_q(talos.q_home)
        b = a.copy()
        # bends, turns and shifts of the pelvis, with the arm moving or at rest
        b[:6] += rng.uniform(-1.0, 1.0, 6) * (0.08, 0.06, 0.05, 0.15, 0.5, 0.4) - (
            0.0,
            0.0,
            0.06,
            0.0,
            0.0,
            0.0,
        )
        if k % 2:
            arm = [space.index(joint) for joint in talos.description.groups["right_arm"]]
            b[arm] += rng.uniform(-0.4, 0.4, 7)
        clear = CollisionKernel.standing(arrays, StandingRobot(talos, stance), PlanningScene())
        if not clear.edge_is_free(a, b):
            continue
        share = rng.uniform(0.05, 0.95)
        q = space.to_q((a + share * (b - a))[None])[0][0]
        tip = talos.frame_pose(q, "gripper_right_fingertip_1_link")
        speck = SceneObject("speck", Ball(0.0005), tip)
        blocked = CollisionKernel.standing(
            arrays, StandingRobot(talos, stance), PlanningScene().with_object(speck)
        )

        assert not blocked.edge_is_free(a, b)
        found += 1
    assert found > 25


@pytest.mark.parametrize("holding", [False, True])
def test_a_judge_that_allows_more_answers_as_one_made_for_it(
    arrays, talos, stance, space, make, at_random, holding
):
    rng = np.random.default_rng(21)
    scene = at_random.scene(rng, talos, make, held=holding)
    links = [name for name in arrays.solids_of if "gripper_right" in name]
    more = scene.allowing([(link, name) for link in (*links, *scene.attached) for name in scene.objects])
    first = CollisionKernel.standing(arrays, StandingRobot(talos, stance), scene, 0.004, 0.005)
    shared = first.allowing(more)
    own = CollisionKernel.standing(arrays, StandingRobot(talos, stance), more, 0.004, 0.005)
    strict = CollisionKernel.standing(arrays, StandingRobot(talos, stance), scene, 0.004, 0.005)
    x = [at_random.point(rng, talos, space) for _ in range(150)]

    answers = [(first.is_free(point), shared.is_free(point)) for point in x]

    assert answers == [(strict.is_free(point), own.is_free(point)) for point in x]
    assert sum(loose and not tight for tight, loose in answers) > 2
    assert first.allowing(scene.without_object("table")) is None


def test_a_judge_of_a_held_body_is_made_anew_when_that_may_touch_more_of_the_robot(
    arrays, talos, stance, make, at_random
):
    scene = at_random.scene(np.random.default_rng(21), talos, make, held=True)
    first = CollisionKernel.standing(arrays, StandingRobot(talos, stance), scene)
    (held,) = scene.attached

    assert first.allowing(scene.allowing([(held, "torso_2_link")])) is None
    assert first.allowing(replace(scene, attached=dict(scene.attached))) is None


def test_distances_are_lower_bounds_and_nearly_coals(arrays, talos, stance, space, make, at_random):
    rng = np.random.default_rng(3)
    scene = at_random.scene(rng, talos, make)
    kernel, world = both(arrays, talos, stance, scene, 0.0, 0.0)
    geometry, data = world._geometry, world._geometry_data
    names = [tuple(sorted((world._names[p.first], world._names[p.second]))) for p in geometry.collisionPairs]
    compared = 0
    for _ in range(4):
        q = space.to_q(at_random.point(rng, talos, space)[None])[0][0]
        pin.computeDistances(talos.pin, world._data, geometry, data, q)
        theirs = dict(zip(names, (result.min_distance for result in data.distanceResults), strict=True))
        for pair, ours in enumerate(kernel.distances_m(q, cap_m=0.5)):
            expected = theirs[tuple(sorted(kernel.pair_names(pair)))]
            assert ours <= max(expected, 0.0) + 1e-5
            if 0.0 < expected < 0.3:
                assert ours >= expected - 1e-4
                compared += 1
    assert compared > 200


def test_allowed_pairs_are_not_judged_and_touch_links_may_touch(arrays, talos, stance):
    links = talos.description.grippers["right"].links
    place = talos.frame_pose(talos.q_home, "tcp_right")
    scene = PlanningScene().with_object(SceneObject("ball", Ball(0.05), place))

    assert both(arrays, talos, stance, scene)[0].colliding_pair(talos.q_home)[1] == "ball"
    assert not both(arrays, talos, stance, scene.allowing((link, "ball") for link in links))[0].collides(
        talos.q_home
    )


def test_a_body_on_an_unknown_frame_is_refused(arrays, talos, stance):
    scene = PlanningScene().with_object(SceneObject("cup", Ball(0.05), np.eye(4)))
    with pytest.raises(UnknownNameError):
        CollisionKernel.standing(
            arrays, StandingRobot(talos, stance), scene.with_attached("cup", "hook", np.eye(4), ())
        )


def test_the_same_questions_get_the_same_answers_to_the_bit(arrays, talos, stance, space, make, at_random):
    def answers():
        rng = np.random.default_rng(5)
        kernel = CollisionKernel.standing(
            arrays, StandingRobot(talos, stance), at_random.scene(rng, talos, make), 0.004, 0.005
        )
        edges = [np.stack(random_edge(rng, talos, space, at_random, 0.5)) for _ in range(20)]
        return [kernel.polyline_refusal(edge) for edge in edges], kernel.distances_m(talos.q_home).tobytes()

    assert answers() == answers()


def test_nothing_is_compiled_twice(arrays, talos, stance, space, make, at_random):
    rng = np.random.default_rng(6)
    kernel = CollisionKernel.standing(arrays, StandingRobot(talos, stance), at_random.scene(rng, talos, make))
    empty = CollisionKernel(arrays, PlanningScene())
    point = at_random.point(rng, talos, space)
    kernel.is_free(point)
    kernel.polyline_is_free(np.asfortranarray(np.stack([point, point])))
    empty.distances_m(talos.q_home)

    assert len(door.ask.signatures) == 1


def welded_arm():
    """A hinge, a slide on it and a box at its end; a post stands in the way."""
    model, geometry = pin.Model(), pin.GeometryModel()
    hinge = model.addJoint(0, pin.JointModelRZ(), pin.SE3.Identity(), "hinge")
    slide = model.addJoint(hinge, pin.JointModelPX(), pin.SE3.Identity(), "slide")
    place = pin.SE3(np.eye(3), np.array([0.5, 0.0, 0.0]))
    geometry.addGeometryObject(pin.GeometryObject("hand", slide, place, coal.Box(0.1, 0.02, 0.02)))
    return RobotArrays(model, geometry, ["hand"])


@pytest.mark.parametrize(("out_m", "free"), [(0.0, True), (0.5, False)])
def test_a_welded_arm_of_hinge_and_slide_is_judged_too(out_m, free):
    post = SceneObject("post", Box((0.01, 0.01, 1.0)), poses.translation(0.0, 1.0, 0.0))
    kernel = CollisionKernel(welded_arm(), PlanningScene().with_object(post))

    assert kernel.edge_is_free(np.array([0.0, out_m]), np.array([3.0, out_m])) is free
