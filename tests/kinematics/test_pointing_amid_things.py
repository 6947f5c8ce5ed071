"""Above a high table an arm points with its elbow up, or with its palm in the table."""

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box, Cylinder
from kinematics.ik.arm_frames import pointing_error_m
from kinematics.model.robot_description import HANDS
from kinematics.planning.gesture_planner import GesturePlanner
from kinematics.requests.gesture import PointRequest
from kinematics.requests.move import MovePlan
from kinematics.scene.planning_scene import PlanningScene, SceneObject

TARGET_M = (0.59, -0.36, 1.01)
THINGS = (
    SceneObject("table", Box((0.65, 1.2, 0.04)), poses.translation(0.67, 0.02, 0.95), 0.015, movable=False),
    SceneObject("box", Box((0.046, 0.067, 0.079)), poses.translation(*TARGET_M), 0.01),
    SceneObject("can", Cylinder(0.026, 0.108), poses.translation(0.64, 0.1, 1.03), 0.01),
    SceneObject("red can", Cylinder(0.025, 0.101), poses.translation(0.52, 0.26, 1.02), 0.01),
)


def test_whatever_the_seed_an_arm_points_at_a_thing_on_a_high_table(talos, stance):
    scene, planner = PlanningScene().with_objects(THINGS), GesturePlanner(talos)

    for seed in range(8):
        plan = planner.plan(PointRequest(talos.q_home, stance, scene, TARGET_M, seed=seed))

        assert isinstance(plan, MovePlan), f"seed {seed}"
        end = plan.step.trajectory.q[-1]
        assert min(pointing_error_m(talos, end, hand, TARGET_M) for hand in HANDS) < 0.05
