"""Values that leaves read at their ports."""

import numpy as np
import pytest

from kinematics import poses
from kinematics.requests import Grasp, PickRequest
from kinematics.scene import SceneObject
from kinematics.shapes import Cylinder
from trees.steps import CheckedStep, Step, Target

CUP_POSE = poses.translation(0.45, -0.2, 0.955)


@pytest.fixture
def target():
    return Target("red cup", "cup", "red", Cylinder(0.03, 0.11), CUP_POSE, 0.95)


@pytest.fixture
def knowing(stage, target):
    """The stage, with the red cup in the world model."""
    stage.told.update(stage.told.scene.with_object(SceneObject("red cup", target.shape, CUP_POSE, 0.01)))
    return stage


@pytest.fixture
def planned(knowing):
    """Grasp and steps of a pick, as the planner would give them."""
    fake, scene = knowing.fake, knowing.told.scene
    plan = fake.planning.answer(PickRequest(fake.motion.reference(), fake.motion.stance(), scene, "red cup"))

    class Planned:
        grasp = plan.grasp

        @staticmethod
        def step(name):
            step = getattr(plan, name)
            return Step(name, step.trajectory, step.scene, scene.version, step.concessions)

        @staticmethod
        def checked(name):
            step = getattr(plan, name)
            checked = fake.planning.answer(step.question)
            return CheckedStep(name, checked, scene.version)

        @staticmethod
        def play(*names):
            """Bring the fake robot to the end of these steps."""
            for name in names:
                handle = fake.motion.start(Planned.checked(name).checked)
                while not handle.finished:
                    fake.step()
                assert handle.status.value == "done", handle.reason

        @staticmethod
        def grip():
            """Reach, approach, close: the fake hand holds the cup."""
            Planned.play("reach", "approach")
            handle = fake.grippers[plan.grasp.hand].close()
            while not handle.finished:
                fake.step()

    return Planned


@pytest.fixture
def right_grasp():
    return Grasp("right", "side", np.eye(4), 0.1, 0.06)


@pytest.fixture
def hold_level(stage):
    """Puts a solid into the left hand, its own axes along the world's."""

    def hold(shape):
        toolbox = stage.toolbox
        frame = toolbox.model.description.tcp_frames["left"]
        tcp_T_object = poses.inverse(toolbox.model.frame_pose(toolbox.sensing.state().q, frame))
        tcp_T_object[:3, 3] = 0.0
        scene = toolbox.world.scene.with_objects([SceneObject("blue box", shape, np.eye(4))])
        toolbox.world.update(scene.with_attached("blue box", frame, tcp_T_object, ()))

    return hold
