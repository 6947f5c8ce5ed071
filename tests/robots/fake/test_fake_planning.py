import numpy as np
import pytest

from kinematics.requests.move import RetreatRequest
from kinematics.requests.pick import PickRequest
from kinematics.requests.step import NoPlan
from kinematics.scene.planning_scene import PlanningScene, SceneObject


def pick(fake, **options):
    item = fake.world.object("red cup")
    scene = PlanningScene().with_object(SceneObject("red cup", item.shape, item.world_T_object))
    return PickRequest(fake.motion.reference(), fake.motion.stance(), scene, "red cup", **options)


def tcp(fake, q, hand):
    return fake.model.frame_pose(q, f"tcp_{hand}")[:3, 3]


def test_a_pick_brings_the_nearer_hand_to_the_object_and_lifts_it(fake):
    plan = fake.planning.answer(pick(fake))
    cup = fake.world.object("red cup").world_T_object[:3, 3]

    lift = np.array([0.0, 0.0, 0.13])

    assert plan.grasp.hand == "right"
    np.testing.assert_allclose(tcp(fake, plan.approach.trajectory.q[-1], "right"), cup, atol=1e-4)
    np.testing.assert_allclose(tcp(fake, plan.lift.trajectory.q[-1], "right"), cup + lift, atol=1e-3)


def test_each_step_starts_where_the_one_before_ends(fake):
    plan = fake.planning.answer(pick(fake))

    np.testing.assert_array_equal(plan.reach.trajectory.q[-1], plan.approach.trajectory.q[0])
    np.testing.assert_array_equal(plan.approach.trajectory.q[-1], plan.lift.trajectory.q[0])


def test_excluded_grasps_are_left_out_until_none_is_left(fake):
    labels = ("side", "top", "diagonal", "far side")
    right = frozenset(f"right {label}" for label in labels)

    assert fake.planning.answer(pick(fake, excluded=right)).grasp.hand == "left"
    assert isinstance(fake.planning.answer(pick(fake, excluded=right, hands=("right",))), NoPlan)


def test_a_retreat_moves_the_hand_by_its_offset(fake):
    start = fake.motion.reference()
    request = RetreatRequest(start, fake.motion.stance(), PlanningScene(), "left", (0.0, 0.0, -0.1))

    end = fake.planning.answer(request).step.trajectory.q[-1]

    np.testing.assert_allclose(tcp(fake, end, "left") - tcp(fake, start, "left"), (0, 0, -0.1), atol=1e-4)


def test_a_job_takes_its_time(fake):
    fake.planning.delay_s = 0.05
    job = fake.planning.submit(pick(fake))
    waited = 0
    while not job.done:
        fake.step()
        waited += 1

    assert waited == 3


def test_a_job_that_hangs_is_never_done(fake):
    fake.planning.hangs = True
    job = fake.planning.submit(pick(fake))
    for _ in range(100):
        fake.step()

    assert not job.done


def test_a_cancelled_job_is_never_done(fake):
    job = fake.planning.submit(pick(fake))
    job.cancel()
    fake.step()

    assert not job.done


def test_a_planner_can_be_made_to_raise(fake):
    fake.planning.raises = RuntimeError("Infeasible QP")
    job = fake.planning.submit(pick(fake))

    with pytest.raises(RuntimeError, match="Infeasible"):
        job.result()
