import itertools

import coal
import numpy as np
import pinocchio as pin
import pytest

from kinematics.collision.collision_world import CollisionWorld, with_floor
from kinematics.collision.validity import validity
from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball, Box, Cylinder
from kinematics.kernel.collision_kernel import CollisionKernel
from kinematics.kernel.robot_arrays import RobotArrays
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import Stance
from kinematics.model.standing_robot import StandingRobot
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from kinematics.standing.free_coordinates import FreeCoordinates
from robots.models.description import load_description

START, GOAL = np.array([0.0, 0.5]), np.array([3.0, 0.5])
LOWER, UPPER = np.array([-0.2, -0.6]), np.array([3.2, 0.6])
WEIGHTS = np.ones(2)
# all the way in, around, and out again
DETOUR = np.array([START, [0.0, -0.5], [3.0, -0.5], GOAL])


def crane(*objects):
    """A hinge, a slide on it and a box at its end, that can pull in."""
    model, geometry = pin.Model(), pin.GeometryModel()
    hinge = model.addJoint(0, pin.JointModelRZ(), pin.SE3.Identity(), "hinge")
    slide = model.addJoint(hinge, pin.JointModelPX(), pin.SE3.Identity(), "slide")
    place = pin.SE3(np.eye(3), np.array([0.5, 0.0, 0.0]))
    geometry.addGeometryObject(pin.GeometryObject("hand", slide, place, coal.Box(0.1, 0.02, 0.02)))
    return CollisionKernel(RobotArrays(model, geometry, ["hand"]), PlanningScene().with_objects(objects))


def post():
    """It stands where the hand would pass when it is not pulled in."""
    return SceneObject("post", Box((0.01, 0.01, 1.0)), poses.translation(0.0, 1.0, 0.0))


def searched(kernel, seed=3, goal=GOAL, iterations=500):
    return kernel.connect(START, goal, LOWER, UPPER, WEIGHTS, 0.5, iterations, seed)


def length(polyline):
    return float(np.sum(np.linalg.norm(np.diff(polyline, axis=0), axis=1)))


def test_a_way_around_a_post_is_found_and_proven():
    kernel = crane(post())

    way = searched(kernel)

    assert not kernel.edge_is_free(START, GOAL)
    assert way is not None
    assert np.array_equal(way[0], START)
    assert np.array_equal(way[-1], GOAL)
    assert kernel.polyline_is_free(way)


def test_one_seed_gives_one_way_and_another_seed_another():
    ways = [searched(crane(post()), seed) for seed in (3, 3, 4, 2**53 - 1)]

    assert np.array_equal(ways[0], ways[1])
    assert all(way is not None for way in ways)
    assert not np.array_equal(ways[0], ways[2])


def test_there_is_no_way_to_a_goal_that_collides():
    assert searched(crane(post()), goal=np.array([np.pi / 2, 0.5])) is None


def test_there_is_no_way_through_a_wall_however_long_it_is_searched():
    wall = SceneObject("wall", Box((0.01, 4.0, 1.0)), poses.translation(0.0, 2.0, 0.0))

    assert searched(crane(wall), iterations=300) is None


def test_corners_that_are_not_needed_are_left_out_of_a_way():
    # steps of a fifth of what lies between them: the trees alone would give as many corners
    way = crane(post()).connect(START, GOAL, LOWER, UPPER, WEIGHTS, 0.2, 2000, 3)

    assert length(way) / (len(way) - 1) > 0.4


def rod():
    """As the post, but so thin that hardly any look of the search meets it."""
    return SceneObject("rod", Cylinder(0.0005, 1.0), poses.translation(0.0, 1.0, 0.0))


@pytest.mark.parametrize("seed", range(5))
def test_a_rod_that_looks_in_points_miss_is_passed_by_proven_lines(seed):
    kernel = crane(rod())

    way = searched(kernel, seed)

    assert way is not None
    assert kernel.polyline_is_free(way)


@pytest.mark.parametrize("thing", [post(), rod()], ids=["post", "rod"])
def test_shortening_keeps_the_ends_and_proves_what_it_puts_in(thing):
    kernel, way = crane(thing), DETOUR

    short = kernel.shorten(way, WEIGHTS, 60)

    assert np.array_equal(short[0], START)
    assert np.array_equal(short[-1], GOAL)
    assert length(short) < 0.9 * length(way)
    assert kernel.polyline_is_free(short)
    assert np.array_equal(short, kernel.shorten(way, WEIGHTS, 60))


def test_shortening_leaves_out_all_corners_where_nothing_is_in_the_way():
    short = crane().shorten(DETOUR, WEIGHTS, 60)

    assert np.array_equal(short, [START, GOAL])


def test_more_attempts_never_make_a_way_longer():
    kernel, way = crane(post()), DETOUR

    lengths = [length(kernel.shorten(way, WEIGHTS, attempts)) for attempts in (0, 1, 5, 20, 100)]

    assert lengths[0] == pytest.approx(length(way))
    assert all(later <= earlier + 1e-12 for earlier, later in itertools.pairwise(lengths))


def test_an_arms_edges_that_are_proven_are_free_wherever_coal_looks():
    """Of an arm whose joints turn at one speed: their motion is bounded along the separating direction."""
    model = RobotModel(load_description("panda"))
    stance = Stance(())
    space = FreeCoordinates(StandingRobot(model, stance))
    rng = np.random.default_rng(11)
    proven = refused = pessimistic = 0
    for _ in range(6):
        things = [
            SceneObject(
                f"thing_{k}", shape, poses.translation(*rng.uniform([-0.7, -0.7, 0.05], [0.7, 0.7, 0.9]))
            )
            for k, shape in enumerate([Box((0.05, 0.2, 0.1)), Ball(0.06), Box((0.004, 0.004, 0.5))] * 2)
        ]
        scene = PlanningScene().with_objects(things)
        kernel = validity(StandingRobot(model, stance), scene)
        world = CollisionWorld(model, with_floor(model, scene))
        for _ in range(40):
            a = rng.uniform(model.lower_rad[:7] + 0.02, model.upper_rad[:7] - 0.02)
            step = rng.normal(size=7)
            b = np.clip(
                a + step / np.linalg.norm(step), model.lower_rad[:7] + 0.02, model.upper_rad[:7] - 0.02
            )
            q = space.to_q(a + (b - a) * np.linspace(0.0, 1.0, 150)[:, None])[0]
            free = kernel.polyline_is_free(np.stack([a, b]))
            truth = not any(world.collides(configuration) for configuration in q)
            assert truth or not free
            proven += free
            refused += not truth
            pessimistic += truth and not free
    assert proven > 40
    assert refused > 40
    assert pessimistic <= 0.02 * (proven + refused)
