import numpy as np
import pytest

from kinematics.collision.collision_world import CollisionWorld
from kinematics.collision.validity import SampledValidity, validity
from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from kinematics.model.standing_robot import StandingRobot
from kinematics.planning.path_planner import PathPlanner, PathSettings
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from kinematics.standing.free_coordinates import FreeCoordinates


def problem(talos, stance):
    """The right hand has to get past a post that stands in the straight way."""
    space = FreeCoordinates(StandingRobot(talos, stance))
    start = space.from_q(talos.q_home)
    goal = start.copy()
    goal[space.index("arm_right_4_joint")] = -0.6
    middle = space.to_q((0.5 * (start + goal))[None, :])[0][0]
    place = talos.frame_pose(middle, "tcp_right")
    post = SceneObject("post", Box((0.03, 0.03, 0.1)), poses.translation(*place[:3, 3]))
    moving = [space.index(joint) for joint in talos.description.groups["right_arm"]]
    return space, start, goal, moving, PlanningScene().with_object(post)


@pytest.mark.parametrize("compiled", [True, False])
def test_a_detour_is_found_where_the_straight_line_is_blocked(talos, stance, compiled):
    space, start, goal, moving, scene = problem(talos, stance)
    world = CollisionWorld(talos, scene)
    judge = (
        validity(StandingRobot(talos, stance), scene)
        if compiled
        else SampledValidity(StandingRobot(talos, stance), world)
    )
    assert (judge.path_search() is not None) == compiled
    planner = PathPlanner(talos, space, judge, PathSettings(iterations=600))

    curve = planner.plan(start, goal, moving, np.random.default_rng(0))

    assert curve is not None
    q, reached = space.to_q(curve(np.linspace(0, 1, 400)))
    assert reached.all()
    assert not any(world.collides(configuration) for configuration in q)
    straight = space.to_q(start + (goal - start) * np.linspace(0, 1, 50)[:, None])[0]
    assert any(world.collides(configuration) for configuration in straight)


def test_the_same_seed_gives_the_same_path(talos, stance):
    space, start, goal, moving, scene = problem(talos, stance)
    planner = PathPlanner(
        talos, space, validity(StandingRobot(talos, stance), scene), PathSettings(iterations=600)
    )
    s = np.linspace(0, 1, 20)

    first = planner.plan(start, goal, moving, np.random.default_rng(7))
    second = planner.plan(start, goal, moving, np.random.default_rng(7))

    assert np.array_equal(first(s), second(s))


def test_a_goal_in_collision_has_no_path(talos, stance):
    space, start, goal, moving, scene = problem(talos, stance)
    q = space.to_q(goal[None, :])[0][0]
    blocked = scene.with_object(
        SceneObject(
            "block", Box((0.1, 0.1, 0.1)), poses.translation(*talos.frame_pose(q, "tcp_right")[:3, 3])
        )
    )
    planner = PathPlanner(talos, space, validity(StandingRobot(talos, stance), blocked))

    assert planner.plan(start, goal, moving, np.random.default_rng(0)) is None


def test_without_the_compiled_kernel_coal_judges(talos, stance, monkeypatch):
    monkeypatch.setattr("kinematics.collision.validity._kernel_is_there", lambda: False)

    assert isinstance(validity(StandingRobot(talos, stance), PlanningScene()), SampledValidity)
