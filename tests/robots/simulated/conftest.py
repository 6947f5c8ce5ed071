"""A robot that stands in a simulated world, and one that holds a cup by friction alone."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
import pinocchio as pin
import pytest

from kinematics.dynamics.standing_dynamics import StandingDynamics
from kinematics.geometry import poses
from kinematics.geometry.shapes import Cylinder
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import Stance
from kinematics.model.standing_robot import StandingRobot
from robots.interface.hardware import RobotData
from robots.interface.robot import JointSetpoint
from robots.models.description import load_description, load_robot
from robots.scenes.scene_description import SceneDescription, SceneItem
from robots.simulated.world import build_world

HARDWARE = load_robot("talos").hardware

PERIOD_S = 0.002


@pytest.fixture(scope="session")
def description():
    return load_description("talos")


@pytest.fixture(scope="session")
def robot_model(description):
    return RobotModel(description)


class Stand:
    """The least that keeps a robot on its feet: gravity and the soles' wrenches as feed-forward."""

    def __init__(self, model: RobotModel, scene: SceneDescription, seed: int = 0) -> None:
        self.model, self.description = model, model.description
        self.world = build_world(RobotData(self.description, HARDWARE), scene, np.random.default_rng(seed))
        self.robot, self.truth = self.world.robot, self.world.truth
        self.q = model.q_home.copy()
        soles = [(sole.frame, model.frame_pose(self.q, sole.frame)) for sole in self.description.soles]
        self.dynamics = StandingDynamics(StandingRobot(model, Stance(tuple(soles))))
        self.gripper = np.zeros(len(self.description.gripper_joints))
        self.sequence = 0
        self.hold_posture(self.q[7:])

    def hold_posture(self, joints) -> None:
        self.q[7:] = joints
        self.tau = np.concatenate([self.dynamics.holding_efforts(self.q), np.zeros(self.gripper.size)])

    def step(self) -> None:
        q = np.concatenate([self.q[7:], self.gripper])
        self.sequence += 1
        self.robot.command(JointSetpoint(0.0, self.sequence, "test", q, np.zeros_like(q), self.tau))
        self.robot.advance(PERIOD_S)

    def run(self, seconds: float, each=None) -> None:
        for _ in range(round(seconds / PERIOD_S)):
            if each is not None:
                each()
            self.step()

    def move_to(self, joints, seconds: float) -> None:
        start, count = self.q[7:].copy(), round(seconds / PERIOD_S)
        for i in range(1, count + 1):
            s = i / count
            self.hold_posture(start + (joints - start) * s * s * s * (10.0 + s * (6.0 * s - 15.0)))
            self.step()


@pytest.fixture(scope="session")
def stand_class():
    return Stand


@pytest.fixture
def stand(robot_model):
    return lambda scene, seed=0: Stand(robot_model, scene, seed)


def _arm_posture(model: RobotModel, hand: str, world_T_tcp) -> np.ndarray:
    """Joints that bring a TCP to a pose with the arm alone, by damped Gauss-Newton."""
    q, data = model.q_home.copy(), model.pin.createData()
    frame = model.frame_id(model.description.grippers[hand].tcp_frame)
    columns = 6 + model.group(f"{hand}_arm")
    target = pin.SE3(world_T_tcp)
    for _ in range(300):
        pin.framesForwardKinematics(model.pin, data, q)
        error = pin.log6(data.oMf[frame].actInv(target)).vector
        if np.linalg.norm(error) < 1e-5:
            break
        J = pin.computeFrameJacobian(model.pin, data, q, frame, pin.LOCAL)[:, columns]
        step = J.T @ np.linalg.solve(J @ J.T + 1e-4 * np.eye(6), error)
        reached = q[columns + 1] + np.clip(step, -0.1, 0.1)
        q[columns + 1] = np.clip(reached, model.lower_rad[columns - 6], model.upper_rad[columns - 6])
    assert np.linalg.norm(error) < 1e-5
    return q[7:]


@pytest.fixture(scope="session")
def arm_posture():
    return _arm_posture


@dataclass
class Hold:
    """A cup in a hand, and what was seen on the way."""

    stand: Stand
    hand: str = "left"
    cup: str = "cup"
    efforts: list[float] = field(default_factory=list)

    @property
    def truth(self):
        return self.stand.truth

    def gripper_index(self) -> int:
        return self.stand.description.gripper_joints.index(self.stand.description.grippers[self.hand].joint)

    def press(self, effort_nm: float) -> None:
        """Squeeze with a constant effort by a setpoint that stays as far inside the cup as it needs."""
        index = self.gripper_index()
        joint = len(self.stand.description.joints) + index
        kp = self.stand.robot.hardware.gains[self.stand.description.gripper_joints[index]].stiffness
        self.stand.gripper[index] = self.truth.joint_positions()[joint] - effort_nm / kp

    def close(self, effort_nm: float, seconds: float = 0.8, lying_above_m: float | None = None) -> None:
        """Close on the cup while something holds it in the air, then let go of it.

        Args:
            effort_nm: The gripper's.
            seconds: Until it is let go.
            lying_above_m: The cup lies along the fingers, so far above the hand's middle; else it stands.
        """
        place = poses.translation(*self.truth.world_T_tcp(self.hand)[:3, 3])
        if lying_above_m is not None:
            place = place @ poses.transform(poses.rotation_y(0.5 * np.pi), (0.0, 0.0, lying_above_m))

        def each() -> None:
            self.stand.world.faults.teleport(self.cup, place)
            self.press(effort_nm)

        self.stand.run(seconds, each)
        self.stand.run(0.5)

    def sunk_m(self, seconds: float) -> float:
        """How far the cup slides down in the hand."""
        before = self.truth.tcp_T_object(self.hand, self.cup)[2, 3]
        self.stand.run(seconds)
        return float(before - self.truth.tcp_T_object(self.hand, self.cup)[2, 3])


@pytest.fixture
def cup_in_hand(robot_model):
    def make(mass_kg=0.3, radius_m=0.03, friction=0.6, hand="left", effort_nm=None, lying_above_m=None):
        item = SceneItem(
            "cup",
            "cup",
            "red",
            Cylinder(radius_m, 0.11),
            mass_kg,
            friction,
            poses.translation(3.0, 0.0, 0.055),
        )
        stand = Stand(robot_model, SceneDescription("hand", objects=(item,)))
        side = 1.0 if hand == "left" else -1.0
        stand.move_to(_arm_posture(robot_model, hand, poses.translation(0.35, side * 0.30, 1.05)), 1.5)
        stand.run(0.2)
        hold = Hold(stand, hand)
        effort_nm = HARDWARE.grips[hand].effort_nm if effort_nm is None else effort_nm
        hold.close(effort_nm, lying_above_m=lying_above_m)
        return hold

    return make
