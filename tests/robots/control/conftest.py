"""A robot that follows perfectly and weighs nothing, and smooth motions for it."""

from __future__ import annotations

import numpy as np
import pytest

from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import stance_at
from kinematics.motion.trajectory import Trajectory
from kinematics.motion.verdict import CheckedTrajectory, _Seal
from robots.clock import ManualClock
from robots.control.loop.control_loop import ControlLoop
from robots.interface.robot import RobotState
from robots.models.description import load_description, load_robot

HARDWARE = load_robot("talos").hardware

PERIOD_S = 0.002


class PerfectRobot:
    """Is always where it was told to be; fingers stop at what stands between them."""

    def __init__(self, model, joints):
        self.description, self.hardware = model.description, HARDWARE
        self._gravity = 9.81 * model.imu_up
        description = model.description
        self.commands = []
        self.obstacle_rad = {}
        self.stuck_rad = {}
        self._q = np.array(joints)
        self._v = np.zeros_like(self._q)
        self._effort = np.zeros_like(self._q)
        self._stamp_ns = 0
        self._followed = None
        self._damping = np.array([HARDWARE.gains[name].damping for name in description.actuated])
        self._stiffness = np.array([HARDWARE.gains[name].stiffness for name in description.actuated])

    def read(self):
        feet = np.zeros((2, 6))
        feet[:, 2] = 450.0
        felt = np.zeros(3), self._gravity
        return RobotState(self._stamp_ns * 1e-9, self._q, self._v, self._effort, *felt, feet)

    def command(self, setpoint):
        self.commands.append(setpoint)

    def advance(self, period_s):
        self._stamp_ns += round(period_s * 1e9)
        setpoint = self.commands[-1]
        q, v, effort = setpoint.q.copy(), setpoint.v.copy(), setpoint.tau.copy()
        for joint, limit in self.obstacle_rad.items():
            i = self.description.actuated.index(joint)
            if q[i] < limit:
                effort[i] += self._stiffness[i] * (q[i] - limit)
                effort[i] += HARDWARE.gains[joint].damping * v[i]
                q[i], v[i] = limit, 0.0
        for joint, place in self.stuck_rad.items():
            i = self.description.actuated.index(joint)
            limit = self.description.limits[joint].effort
            damping = HARDWARE.gains[joint].damping * v[i]
            effort[i] = np.clip(effort[i] + self._stiffness[i] * (q[i] - place) + damping, -limit, limit)
            q[i], v[i] = place, 0.0
        arrived = setpoint is self._followed  # it holds what it was told before
        if arrived:
            effort += self._damping * v
        self._q, self._v, self._effort = q, np.zeros_like(q) if arrived else v, effort
        self._followed = setpoint


class Rig:
    """A control loop on a perfect robot."""

    def __init__(self, model):
        self.model, self.description = model, model.description
        home = [self.description.home[name] for name in self.description.actuated]
        self.robot = PerfectRobot(model, home)
        self.clock, self.events = ManualClock(), []
        self.loop = ControlLoop(self.robot, model, self.clock, self.events.append, PERIOD_S)

    def run(self, seconds):
        for _ in range(round(seconds / PERIOD_S)):
            self.loop.step()

    def run_until(self, condition, within_s=5.0):
        for _ in range(round(within_s / PERIOD_S)):
            if condition():
                return
            self.loop.step()
        raise AssertionError("it never came to that")

    def of_kind(self, kind):
        return [event for event in self.events if isinstance(event, kind)]

    def commanded(self, joint):
        """Positions and velocities that reached the robot."""
        i = self.description.actuated.index(joint)
        return np.array([(s.q[i], s.v[i]) for s in self.robot.commands])


@pytest.fixture(scope="session")
def talos():
    return RobotModel(load_description("talos"))


@pytest.fixture
def new_rig(talos):
    return lambda: Rig(talos)


@pytest.fixture
def rig(new_rig):
    return new_rig()


def smooth(model, q, offsets, duration_s=1.0, step_s=0.01):
    """Quintic from rest to rest, sealed without having been checked."""
    n = round(duration_s / step_s)
    t = np.linspace(0.0, duration_s, n + 1)
    u = t / duration_s
    s, ds = u**3 * (10 - 15 * u + 6 * u**2), 30 * u**2 * (1 - u) ** 2 / duration_s
    qs, vs = np.repeat(q[None], n + 1, axis=0), np.zeros((n + 1, model.nv))
    for joint, offset in offsets.items():
        i = model.joint_index(joint)
        qs[:, 7 + i] += offset * s
        vs[:, 6 + i] = offset * ds
    return sealed(Trajectory(model.joints, stance_at(model, q), t, qs, vs))


def sealed(trajectory):
    return CheckedTrajectory(trajectory, 0.1, 0.1, _Seal(trajectory))


@pytest.fixture(scope="session")
def motions(talos):
    class Motions:
        @staticmethod
        def arms(q, amount=0.4, duration_s=1.0):
            arms = {"arm_left_2_joint": amount, "arm_right_2_joint": -amount}
            return smooth(talos, q, {**arms, "torso_1_joint": 0.2 * amount}, duration_s)

        @staticmethod
        def joint(q, joint, offset, duration_s=1.0):
            return smooth(talos, q, {joint: offset}, duration_s)

    Motions.sealed = staticmethod(sealed)
    return Motions
