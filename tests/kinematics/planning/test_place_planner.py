"""Putting down: ways down that are free, and what is tried when none is found at first."""

import dataclasses

import numpy as np
import pytest

from kinematics.checking.trajectory_checker import TrajectoryChecker
from kinematics.collision.collision_world import CollisionWorld
from kinematics.geometry import poses
from kinematics.geometry.shapes import Box, Cylinder
from kinematics.ik.reach_ik import ReachIk
from kinematics.model.robot_model import RobotModel
from kinematics.motion.verdict import CheckedTrajectory, Unsafe
from kinematics.planning import place_planner, place_task, planning_task
from kinematics.planning.place_planner import PlacePlanner
from kinematics.planning.place_task import TURNS_RAD
from kinematics.requests.place import PlacePlan, PlaceRequest, Spot
from kinematics.requests.step import NoPlan
from kinematics.scene.planning_scene import PlanningScene, SceneObject

BOX = Box((0.066, 0.050, 0.117))
# The hand is level, and the fingers close 14 mm above the box's middle.
TCP_T_BOX = poses.transform(poses.rotation_z(-0.5 * np.pi), (0.0, 0.0, -0.014))


def request(talos, stance, make, top_m, place, tcp_T_box=TCP_T_BOX, below_m=0.005):
    """A box in the right hand at home, and one spot for it on a table."""
    gripper = talos.description.grippers["right"]
    pose = talos.frame_pose(talos.q_home, gripper.tcp_frame) @ tcp_T_box
    scene = PlanningScene().with_objects([make.table(top_m), SceneObject("box", BOX, pose, margin_m=0.01)])
    held = scene.with_attached("box", gripper.tcp_frame, tcp_T_box, gripper.touch_links)
    spot = Spot(poses.translation(*place, top_m + 0.5 * BOX.height_m), ("table",), below_m=below_m)
    return PlaceRequest(talos.q_home, stance, held, "box", (spot,), seed=3)


@pytest.mark.requirement("M3")
@pytest.mark.parametrize("top_m", [0.85, 0.995])
def test_a_box_is_brought_over_its_spot_and_straight_down(talos, stance, make, top_m):
    asked = request(talos, stance, make, top_m, (0.42, -0.34))

    answer = PlacePlanner(talos).plan(asked)

    assert isinstance(answer, PlacePlan)
    frame = talos.description.tcp_frames["right"]
    ways = answer.lower.trajectory.q
    above, below = (talos.frame_pose(q, frame) @ TCP_T_BOX for q in (ways[0], ways[-1]))
    assert below[:2, 3] == pytest.approx((0.42, -0.34), abs=2e-3)
    assert below[2, 3] == pytest.approx(top_m + 0.5 * BOX.height_m - 0.005, abs=2e-3)
    assert above[2, 3] - below[2, 3] == pytest.approx(0.065, abs=3e-3)
    checker = TrajectoryChecker(talos)
    for step in (answer.transfer, answer.lower):
        verdict = checker.check(step.trajectory, step.scene, step.concessions)
        assert isinstance(verdict, CheckedTrajectory), verdict
    assert isinstance(checker.check(answer.lower.trajectory, answer.lower.scene), Unsafe)


@pytest.mark.requirement("M3")
def test_what_fingers_push_as_they_open_is_let_go_of_so_far_before_its_spot(talos, stance, make):
    usual = talos.description.grippers
    ends_m = float(TCP_T_BOX[0, 3]) + 0.02
    pushing = {
        hand: dataclasses.replace(one, push_table=((0.05, ends_m),), aside_table=((0.05, 0.005),))
        for hand, one in usual.items()
    }
    model = RobotModel(dataclasses.replace(talos.description, grippers=pushing))

    answer = PlacePlanner(model).plan(request(model, stance, make, 0.85, (0.42, -0.34)))

    assert isinstance(answer, PlacePlan)
    hand = model.frame_pose(answer.lower.trajectory.q[-1], model.description.tcp_frames["right"])
    let_go_at, ahead, across = (hand @ TCP_T_BOX)[:2, 3], hand[:2, 0], hand[:2, 1]
    assert let_go_at + 0.02 * ahead + 0.005 * across == pytest.approx((0.42, -0.34), abs=2e-3)


@pytest.mark.requirement("M3")
def test_what_has_no_way_down_with_room_to_spare_goes_down_with_less(talos, stance, make, monkeypatch):
    low = poses.transform(poses.rotation_z(-0.5 * np.pi), (0.0, 0.0, -0.0092))
    asked = request(talos, stance, make, 0.85, (0.42, -0.34), low, below_m=0.0)
    assert isinstance(PlacePlanner(talos).plan(asked), PlacePlan)

    for module in (place_planner, place_task):
        monkeypatch.setattr(module, "LEAST_RESERVE_M", place_planner.RESERVE_M)

    assert isinstance(PlacePlanner(talos).plan(asked), NoPlan)


@pytest.mark.requirement("M3")
def test_where_the_forearm_meets_the_edge_the_elbow_goes_elsewhere(talos, stance, make, monkeypatch):
    asked = request(talos, stance, make, 0.995, (0.52, -0.25))
    assert isinstance(PlacePlanner(talos).plan(asked), PlacePlan)

    monkeypatch.setattr(place_planner, "OTHER_SEEDS", 0)

    assert isinstance(PlacePlanner(talos).plan(asked), NoPlan)


def test_out_of_reach_there_is_no_plan_and_the_reasons_are_counted(talos, stance, make):
    asked = request(talos, stance, make, 0.85, (0.86, 0.5))

    answer = PlacePlanner(talos).plan(asked)

    assert isinstance(answer, NoPlan)
    assert answer.reasons["no inverse kinematics at the spot"] > 0
    assert answer.numbers["spots"] == 1.0


def test_nothing_is_put_down_by_leaning_so_far_that_it_is_taken_for_a_fall(talos, stance, make, monkeypatch):
    monkeypatch.setattr(planning_task, "LEANING_RAD", 1e-4)

    answer = PlacePlanner(talos).plan(request(talos, stance, make, 0.85, (0.42, -0.34)))

    assert isinstance(answer, NoPlan)
    assert "too low or too far over" in answer.reasons


def test_who_asks_quickly_gets_the_plain_plans_and_a_short_no(talos, stance, make):
    high = poses.transform(poses.rotation_z(-0.5 * np.pi), (0.0, 0.0, -0.04))
    plain = request(talos, stance, make, 0.85, (0.42, -0.34), high)
    hard = request(talos, stance, make, 0.995, (0.52, -0.25))
    planner = PlacePlanner(talos)

    short = planner.plan(dataclasses.replace(hard, quick=True))

    assert isinstance(planner.plan(dataclasses.replace(plain, quick=True)), PlacePlan)
    assert isinstance(short, NoPlan)
    assert short.numbers["considered"] == len(TURNS_RAD)
    assert isinstance(planner.plan(hard), PlacePlan)


@pytest.mark.requirement("M3")
def test_a_hand_without_room_below_ends_where_the_box_should_stand(talos, stance, make):
    low = poses.transform(poses.rotation_z(-0.5 * np.pi), (0.0, 0.0, -0.011))
    gripper = talos.description.grippers["right"]

    answer = PlacePlanner(talos).plan(request(talos, stance, make, 0.85, (0.42, -0.34), low))

    assert isinstance(answer, PlacePlan)
    below = talos.frame_pose(answer.lower.trajectory.q[-1], gripper.tcp_frame) @ low
    assert below[2, 3] == pytest.approx(0.85 + 0.5 * BOX.height_m, abs=1e-3)


@pytest.fixture
def searches(monkeypatch):
    """Poses and postures that inverse kinematics were searched for, in order."""
    made, solve = [], ReachIk.solve

    def noted(self, world_T_tcp, q_seed, *more, **named):
        made.append((np.round(world_T_tcp, 9).tobytes(), np.round(q_seed, 9).tobytes()))
        return solve(self, world_T_tcp, q_seed, *more, **named)

    monkeypatch.setattr(ReachIk, "solve", noted)
    return made


def test_a_spot_far_out_of_reach_is_given_up_after_two_turns_from_home(talos, stance, make, searches):
    answer = PlacePlanner(talos).plan(request(talos, stance, make, 0.85, (1.5, -0.34)))

    assert isinstance(answer, NoPlan)
    assert len({pose for pose, _ in searches}) == place_task.FAR_TURNS
    assert len({seed for _, seed in searches}) <= 2  # home, and the posture that holds it


def test_later_rounds_do_not_search_again_what_the_first_has_found(talos, stance, make, searches):
    answer = PlacePlanner(talos).plan(request(talos, stance, make, 0.85, (0.72, 0.25)))

    assert isinstance(answer, NoPlan)
    assert len(searches) == len(set(searches)) > len(TURNS_RAD)


@pytest.mark.parametrize(("aside_m", "least_m"), [(0.10, 0.02), (-0.10, 0.0)])
def test_a_wide_berth_is_kept_of_what_may_stand_elsewhere_where_there_is_room(
    talos, stance, make, aside_m, least_m
):
    asked = request(talos, stance, make, 0.85, (0.42, -0.34))
    other = SceneObject(
        "can", Cylinder(0.03, 0.2), poses.translation(0.42, -0.34 + aside_m, 0.95), margin_m=0.01
    )
    beside = dataclasses.replace(asked, scene=asked.scene.with_objects([other]))

    answer = PlacePlanner(talos).plan(beside)

    assert isinstance(answer, PlacePlan)
    assert answer.lower.scene.objects["can"].margin_m == 0.01
    wide = answer.lower.scene.with_objects([dataclasses.replace(other, margin_m=least_m)])
    world = CollisionWorld(talos, wide)
    assert not any(world.collides(q) for q in answer.lower.trajectory.q[::10])
