"""Ways around things, judged point by point."""

from itertools import pairwise

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.planar import PlanarPose
from kinematics.geometry.shapes import Box, Cylinder
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from kinematics.walking.route.path_planning import Footprint, blocked, clearance_m, footprints, plan_path


def scene(*items):
    return PlanningScene().with_objects(items)


def box(name, x, y, size=(0.6, 1.2, 0.9)):
    return SceneObject(name, Box(size), poses.translation(x, y, 0.5 * size[2]))


def nearest_m(path, obstacles):
    """Least distance of the whole way, looked at each centimetre."""
    least = np.inf
    for a, b in pairwise(path):
        for share in np.linspace(0.0, 1.0, max(2, int(100 * a.distance_m(b)))):
            at = PlanarPose(a.x_m + share * (b.x_m - a.x_m), a.y_m + share * (b.y_m - a.y_m))
            least = min(least, clearance_m(obstacles, at))
    return least


def test_a_free_way_is_straight():
    assert plan_path(PlanarPose(), PlanarPose(3.0, 1.0), (), 0.5) == (PlanarPose(), PlanarPose(3.0, 1.0))


@pytest.mark.parametrize("seed", range(10))
def test_a_way_keeps_its_distance_from_everything(seed):
    rng = np.random.default_rng(seed)
    goal = PlanarPose(5.0, float(rng.uniform(-1.0, 1.0)))
    items = [box(f"table {k}", float(rng.uniform(1.3, 3.7)), float(rng.uniform(-2.0, 2.0))) for k in range(3)]
    items.append(SceneObject("Ana", Cylinder(0.25, 1.7), poses.translation(2.5, 0.0, 0.85)))
    obstacles = footprints(scene(*items))

    path = plan_path(PlanarPose(), goal, obstacles, 0.55)

    assert path is not None
    assert path[0] == PlanarPose()
    assert path[-1] == goal
    assert nearest_m(path, obstacles) >= 0.55 - 0.05


def test_no_way_is_no_way():
    walls = [box("a", 2.0, 0.0, (0.2, 3.0, 2.0)), box("b", -2.0, 0.0, (0.2, 3.0, 2.0))]
    walls += [box("c", 0.0, 1.5, (4.0, 0.2, 2.0)), box("d", 0.0, -1.5, (4.0, 0.2, 2.0))]

    assert plan_path(PlanarPose(), PlanarPose(4.0, 0.0), footprints(scene(*walls)), 0.4) is None


def test_a_way_keeps_its_distance_from_points_that_belong_to_nothing_known():
    points = np.array([(2.0, y) for y in np.arange(-0.5, 0.51, 0.05)])

    path = plan_path(PlanarPose(), PlanarPose(4.0, 0.0), (), 0.5, points)

    assert path is not None
    specks = tuple(Footprint(PlanarPose(x, y), 0.0, 0.0) for x, y in points)
    assert nearest_m(path, specks) >= 0.5 - 0.05


def test_a_path_is_blocked_by_what_is_near_to_any_part_of_it():
    path = (PlanarPose(), PlanarPose(2.0, 0.0), PlanarPose(2.0, 2.0))

    assert blocked(path, np.array([(5.0, 5.0), (2.3, 1.0)]), 0.4)
    assert not blocked(path, np.array([(5.0, 5.0), (2.3, 1.0)]), 0.2)
    assert not blocked(path, np.zeros((0, 2)), 0.4)


def test_what_is_as_high_as_the_hands_takes_more_room():
    low, tall = box("table", 2.0, 0.0, (0.6, 1.2, 0.9)), box("shelf", -2.0, 0.0, (0.6, 1.2, 1.2))

    table, shelf = footprints(scene(low, tall), [(1.0, 0.2)])

    assert clearance_m((table,), PlanarPose()) == pytest.approx(1.7)
    assert clearance_m((shelf,), PlanarPose()) == pytest.approx(1.5)
