import dataclasses
import itertools
from types import SimpleNamespace

import numpy as np
import pytest

from kinematics.collision.collision_world import CollisionWorld
from kinematics.dynamics.standing_dynamics import StandingDynamics
from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball, Box, Cylinder
from kinematics.model.robot_model import RobotModel
from kinematics.model.standing_robot import StandingRobot
from kinematics.planning import pick_planner, pick_task
from kinematics.planning.grasps import ABOVE_MIDDLE
from kinematics.planning.pick_planner import MOST_BLOCKED, PickPlanner
from kinematics.planning.pick_task import PickTask
from kinematics.requests.pick import PickPlan, PickRequest
from kinematics.requests.step import NoPlan
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from kinematics.standing.reserves import PLANNING_RESERVE_M


def never_above_what_is_low(talos):
    """The same robot, whose TCPs go as far down over what is low as over all else."""
    grippers = {
        hand: dataclasses.replace(gripper, lowest_overlap_m=gripper.pad_overlap_m)
        for hand, gripper in talos.description.grippers.items()
    }
    return RobotModel(dataclasses.replace(talos.description, grippers=grippers))


def plan(talos, stance, scene, **options):
    return PickPlanner(talos).plan(PickRequest(talos.q_home, stance, scene, "cup", **options))


@pytest.mark.requirement("M1")
def test_reach_approach_and_lift_are_one_chain(talos, stance, tabletop):
    answer = plan(talos, stance, tabletop)

    assert isinstance(answer, PickPlan)
    steps = [answer.reach, answer.approach, answer.lift]
    assert steps[0].trajectory.q[0] == pytest.approx(talos.q_home, abs=1e-9)
    for before, after in itertools.pairwise(steps):
        assert after.trajectory.q[0] == pytest.approx(before.trajectory.q[-1], abs=1e-9)
    frame = talos.description.grippers[answer.grasp.hand].tcp_frame
    grasped = talos.frame_pose(answer.approach.trajectory.q[-1], frame)
    assert grasped == pytest.approx(answer.grasp.world_T_tcp, abs=3e-3)
    lifted = talos.frame_pose(answer.lift.trajectory.q[-1], frame)
    assert lifted[2, 3] - grasped[2, 3] == pytest.approx(0.13, abs=2e-3)


def test_the_approach_is_straight_and_the_lift_is_vertical(talos, stance, tabletop):
    answer = plan(talos, stance, tabletop)
    frame = talos.description.grippers[answer.grasp.hand].tcp_frame

    for step in (answer.approach, answer.lift):
        places = np.array([talos.frame_pose(q, frame)[:3, 3] for q in step.trajectory.q])
        along = (places[-1] - places[0]) / np.linalg.norm(places[-1] - places[0])
        offset = places - places[0] - np.outer((places - places[0]) @ along, along)
        assert np.linalg.norm(offset, axis=1).max() < 1.5e-3


@pytest.mark.requirement("M5")
def test_the_nearer_hand_is_chosen(talos, stance, make):
    for y, hand in ((-0.3, "right"), (0.3, "left")):
        scene = PlanningScene().with_objects([make.table(), make.cup(y=y)])

        assert plan(talos, stance, scene).grasp.hand == hand


def test_a_good_grasp_is_taken_without_looking_for_a_better_one(talos, stance, tabletop, monkeypatch):
    at_once = plan(talos, stance, tabletop)

    monkeypatch.setattr(pick_planner, "WORTH_WAITING", -np.inf)

    assert at_once.considered < plan(talos, stance, tabletop).considered


def test_room_is_judged_for_those_grasps_alone_whose_turn_comes(talos, stance, tabletop, monkeypatch):
    judged = []
    has_room = PickTask._has_room
    monkeypatch.setattr(
        PickTask,
        "_has_room",
        lambda task, hand, places: judged.append(len(places)) or has_room(task, hand, places),
    )

    assert isinstance(plan(talos, stance, tabletop), PickPlan)
    for_plan = sum(judged)
    judged.clear()
    request = PickRequest(talos.q_home, stance, tabletop, "cup")
    candidates = list(
        PickTask(talos, request, (ABOVE_MIDDLE,), PLANNING_RESERVE_M, upright=True).candidates()
    )

    assert 0 < for_plan < sum(judged)
    assert len(candidates) < sum(judged)


@pytest.mark.requirement("M5")
def test_the_hand_can_be_prescribed(talos, stance, make):
    scene = PlanningScene().with_objects([make.table(), make.cup(y=-0.05)])

    assert plan(talos, stance, scene, hands=("left",)).grasp.hand == "left"


def test_a_low_cup_is_grasped_with_less_room_before_it_is_given_up(talos, stance, monkeypatch):
    top = SceneObject(
        "table", Box((0.64, 1.17, 0.04)), poses.translation(0.63, -0.13, 0.881), margin_m=0.015, movable=False
    )
    low = SceneObject("cup", Cylinder(0.029, 0.07), poses.translation(0.55, -0.04, 0.936), margin_m=0.01)
    scene = PlanningScene().with_objects([top, low])
    talos = never_above_what_is_low(talos)

    assert isinstance(plan(talos, stance, scene), PickPlan)
    monkeypatch.setattr("kinematics.planning.pick_planner.LEAST_RESERVE_M", PLANNING_RESERVE_M)
    monkeypatch.setattr("kinematics.planning.pick_planner.every_height", lambda _: (ABOVE_MIDDLE,))
    assert isinstance(plan(talos, stance, scene), NoPlan)


def test_a_grasp_that_was_excluded_is_not_chosen_again(talos, stance, tabletop):
    first = plan(talos, stance, tabletop)
    excluded = frozenset({f"{first.grasp.hand} {first.grasp.label}"})

    second = plan(talos, stance, tabletop, excluded=excluded)

    assert (second.grasp.hand, second.grasp.label) != (first.grasp.hand, first.grasp.label)


@pytest.mark.requirement("S9")
@pytest.mark.parametrize(
    ("shape", "width_mm"),
    [(Cylinder(0.0634, 0.06), 127), (Box((0.1, 0.2, 0.05)), 100), (Box((0.2, 0.11, 0.3)), 110)],
)
def test_what_no_hand_opens_for_is_said_to_be_too_wide(talos, stance, make, shape, width_mm):
    height_m = make.table().world_T_object[2, 3] + 0.02 + 0.5 * shape.height_m
    wide = SceneObject("cup", shape, poses.translation(0.5, -0.2, height_m), margin_m=0.01)

    answer = plan(talos, stance, PlanningScene().with_objects([make.table(), wide]))

    assert isinstance(answer, NoPlan)
    assert f"the cup is too wide for the hand: {width_mm} mm, and at most 80 mm fit" in answer.message


def test_what_is_out_of_reach_is_said_to_be(talos, stance, make):
    scene = PlanningScene().with_objects([make.table(depth_m=2.0), make.cup(x=1.7)])

    answer = plan(talos, stance, scene)

    assert isinstance(answer, NoPlan)
    assert answer.reasons == {"out of reach": 2}


def test_no_configuration_of_the_reach_collides(talos, stance, make):
    scene = PlanningScene().with_objects(
        [
            make.table(),
            make.cup(),
            make.cup(x=0.42, y=-0.33, name="other"),
            make.cup(x=0.6, y=-0.3, name="third"),
        ]
    )

    answer = plan(talos, stance, scene)

    world = CollisionWorld(talos, scene)
    assert not any(world.collides(q) for q in answer.reach.trajectory.q)


@pytest.mark.parametrize("seed", range(12))
def test_cups_anywhere_on_tables_of_any_height_are_planned(talos, stance, make, seed):
    rng = np.random.default_rng(seed)
    top = rng.uniform(0.75, 1.0)
    cup = make.cup(
        x=rng.uniform(0.37, 0.65),
        y=rng.uniform(-0.45, 0.45),
        top_m=top,
        radius_m=rng.uniform(0.02, 0.038),
        height_m=rng.uniform(0.08, 0.16),
    )
    scene = PlanningScene().with_objects([make.table(top_m=top, edge_m=0.30), cup])

    assert isinstance(plan(talos, stance, scene), PickPlan)


def test_the_same_seed_gives_the_same_plan(talos, stance, tabletop):
    first, second = plan(talos, stance, tabletop, seed=4), plan(talos, stance, tabletop, seed=4)

    assert np.array_equal(first.reach.trajectory.q, second.reach.trajectory.q)
    assert np.array_equal(first.lift.trajectory.q, second.lift.trajectory.q)


class ScriptedTask:
    """Grasps of which a straight reach comes to none, and some of which cannot be lifted from."""

    def __init__(self, lifts):
        self.lifts, self.tried = lifts, []
        self.reasons, self.considered = {}, len(lifts)

    def candidates(self):
        return range(len(self.lifts))

    def solve(self, candidate):
        return candidate

    def straight_reach(self, _way):
        return None

    def completed(self, way):
        return SimpleNamespace(cost=way, way=way)

    def liftable(self, goal):
        return goal if self.lifts[goal.way] else None

    def detour(self, goal):
        self.tried.append(goal.way)
        return goal.way

    def timed(self, goal, _reach):
        return goal.way


def test_grasps_that_cannot_be_lifted_from_do_not_use_up_the_detours(talos):
    task = ScriptedTask([False] * (2 * MOST_BLOCKED) + [True])

    assert PickPlanner(talos)._best(task) == 2 * MOST_BLOCKED
    assert task.tried == [2 * MOST_BLOCKED]


def test_so_many_detours_are_enough(talos):
    task = ScriptedTask([True] * (2 * MOST_BLOCKED))
    task.timed = lambda _goal, _reach: None

    assert PickPlanner(talos)._best(task) is None
    assert len(task.tried) == MOST_BLOCKED


@pytest.mark.requirement("M1")
def test_a_lift_that_would_swing_beyond_joint_limits_keeps_off_them(talos, stance, make, monkeypatch):
    cup = make.cup(x=0.43, y=0.0, top_m=0.88, radius_m=0.0275, height_m=0.0963)
    scene = PlanningScene().with_objects([make.table(top_m=0.88, edge_m=0.3325), cup])
    considered = plan(talos, stance, scene).considered

    monkeypatch.setattr(pick_task, "LINE_RESERVE_RAD", 0.0)

    assert considered < 10 < plan(talos, stance, scene).considered


@pytest.mark.requirement("M1")
def test_over_a_low_box_fingers_that_would_come_too_near_to_the_table_reach_less_far(
    talos, stance, monkeypatch
):
    top = SceneObject(
        "table", Box((0.55, 1.23, 0.04)), poses.translation(0.585, 0.05, 0.77), margin_m=0.015, movable=False
    )
    low = SceneObject(
        "cup", Box((0.041, 0.081, 0.0695)), poses.translation(0.536, 0.157, 0.8245), margin_m=0.01
    )
    scene = PlanningScene().with_objects([top, low])

    assert isinstance(plan(talos, stance, scene), PickPlan)
    assert isinstance(plan(never_above_what_is_low(talos), stance, scene), NoPlan)


LYING = poses.rotation_y(0.5 * np.pi)


@pytest.mark.requirement("M1")
@pytest.mark.parametrize(
    ("shape", "turned", "up_m"),
    [
        (Ball(0.024), np.eye(3), 0.024),
        (Ball(0.033), np.eye(3), 0.033),
        (Ball(0.039), np.eye(3), 0.039),
        (Box((0.05, 0.06, 0.045)), np.eye(3), 0.0225),
        (Cylinder(0.03, 0.12), LYING, 0.03),
        (Cylinder(0.025, 0.12), LYING, 0.025),
    ],
    ids=str,
)
def test_balls_and_what_is_low_or_lies_are_taken_from_above(talos, stance, shape, turned, up_m):
    top = SceneObject(
        "table", Box((0.6, 1.4, 0.04)), poses.translation(0.65, 0.0, 0.86), 0.015, movable=False
    )
    thing = SceneObject("cup", shape, poses.transform(turned, (0.45, -0.2, 0.88 + up_m)), margin_m=0.01)

    answer = plan(talos, stance, PlanningScene().with_objects([top, thing]))

    assert isinstance(answer, PickPlan)
    tcp, middle_m = answer.grasp.world_T_tcp, 0.88 + up_m
    gripper = talos.description.grippers[answer.grasp.hand]
    beyond_m = (tcp[2, 3] - middle_m) * -tcp[2, 0]  # how far before the fingertips its middle is
    assert -tcp[2, 0] > np.sin(np.radians(70.0))
    assert beyond_m < gripper.pad_half_size_m[0][2] + 0.004


@pytest.mark.parametrize("place_m", [(0.95, -0.3), (0.95, 0.1)])
def test_over_a_low_table_no_plan_is_taken_for_a_fall_or_asks_too_much_of_the_legs(
    talos, stance, make, place_m
):
    scene = PlanningScene().with_objects([make.table(0.44, 0.42, 1.1), make.cup(*place_m, top_m=0.44)])

    answer = plan(talos, stance, scene)

    assert isinstance(answer, PickPlan)
    dynamics = StandingDynamics(StandingRobot.of(talos, stance))
    for step in (answer.reach, answer.approach, answer.lift):
        assert step.trajectory.q[:, 2].min() > 0.7 * talos.q_home[2]
        for q in step.trajectory.q[::10]:
            assert (np.abs(dynamics.holding_efforts(q)) < 0.97 * talos.effort).all()
