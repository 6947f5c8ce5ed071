"""The fake robot in its scripted world, put together."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from kinematics.dynamics.standing_dynamics import StandingDynamics
from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Box, Cylinder
from kinematics.model.robot_description import HANDS, Hand
from kinematics.model.robot_model import RobotModel
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.verdict import CheckedTrajectory, Unsafe
from kinematics.requests.check import CheckRequest
from robots.clock import ManualClock
from robots.fake.fake_gripper import FakeGripper
from robots.fake.fake_motion import FakeMotion
from robots.fake.fake_planning import FakePlanning
from robots.fake.fake_robot import FakeRobot
from robots.fake.fake_sensing import FakeRangeSensor, FakeSensing, Sense
from robots.fake.fake_walking import FakeWalking
from robots.fake.fake_yielding import FakeYielding
from robots.fake.scripted_detector import ScriptedDetector
from robots.fake.scripted_world import ScriptedWorld
from robots.interface.hardware import Hardware
from robots.interface.robot import RobotState
from robots.interface.sensed_state import SensedState
from robots.perception.truth_view import TrueObject

SUPPORT_N = 10.0
"""What a support gives to a hand that stands something on it."""
SUPPORT_N_M = 3000.0
"""And for each metre that it is pressed into it."""


class FakeWorld:
    """The fake robot with its world, camera and planner; ``step`` lets time pass.

    Attributes:
        model, clock, robot: As their names say.
        world: The scripted truth.
        motion, grippers, sensing, detector, planning: What a toolbox needs, with switches for failures.
        walking, yielding, ranging: The same, of a toolbox that has them.
        pull_n: Force of somebody on what a hand holds, world axes, N, shape (3,).
    """

    def __init__(
        self,
        model: RobotModel,
        hardware: Hardware,
        check: Callable[[CheckRequest], CheckedTrajectory | Unsafe],
        objects: Iterable[TrueObject],
        period_s: float = 0.02,
        dynamics: StandingDynamics | None = None,
    ) -> None:
        """Put everything together.

        Args:
            model: The robot.
            hardware: What it is made of.
            check: Judges trajectories.
            objects: What is in the world.
            period_s: Time that ``step`` lets pass.
            dynamics: Of the model, standing at home, when somebody has them already.
        """
        self.model, self.clock = model, ManualClock()
        self.pull_n: dict[Hand, tuple[float, float, float]] = {}
        self.robot = FakeRobot(model, hardware, self.clock)
        self.motion = FakeMotion(model, self.clock)
        self._q = self.motion.reference()
        self._placed: tuple[NDArray[np.float64], list[float]] | None = None
        self._told_by: tuple[NDArray[np.float64], NDArray[np.float64]] | None = None
        self._poses: dict[str, Transform] = {}
        self._dynamics = dynamics or StandingDynamics(StandingRobot.of(model, self.motion.stance()))
        camera = model.description.camera
        self.world = ScriptedWorld(objects, self._pose_of, camera.frame)
        self.grippers: Mapping[Hand, FakeGripper] = {
            hand: FakeGripper(
                model.description.grippers[hand], hardware.grips[hand], self.world, self.motion, self._pose_of
            )
            for hand in HANDS
        }
        self.detector = ScriptedDetector(self.world, camera, self.clock)
        self.planning = FakePlanning(model, self.clock, check)
        self.walking = FakeWalking(self.motion)
        self.yielding = FakeYielding(self.motion, self.grippers, self.planning.reach)
        self.ranging = FakeRangeSensor()
        self.sensing = FakeSensing(self.clock.now_s(), self._sense(), period_s)
        self._period_s = period_s
        self._carried_out: tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]] | None = None

    def step(self) -> None:
        """Let one period pass."""
        self.clock.advance(self._period_s)
        self.motion.advance()
        self.walking.advance()
        self.yielding.advance()
        for gripper in self.grippers.values():
            gripper.advance(self._period_s)
        self._follow()
        self.sensing.add(self.clock.now_s(), self._sense())
        self.world.carry()
        self.detector.advance()

    def _follow(self) -> None:
        """Put the robot where motion and grippers have it; there is no control loop in between."""
        posture, fingers = self.motion.posture, [self.grippers[hand].position_rad for hand in HANDS]
        if self._placed is not None and self._placed[0] is posture and self._placed[1] == fingers:
            return
        self.robot.be_at(np.concatenate([posture[7:], fingers]))
        self._placed = None if self.robot.stuck else (posture, fingers)

    def _body_efforts(self) -> Callable[[], NDArray[np.float64]]:
        """Tells what holds the posture of this instant, less what supports and people carry."""
        unwalked, acceleration = self.motion.unwalked(), self.motion.acceleration()
        borne = {}
        for hand, gripper in self.grippers.items():
            pull_n = self.pull_n.get(hand)
            support_n = self._support_n(gripper)
            if pull_n is not None or support_n:
                borne[hand] = np.add(pull_n or (0.0, 0.0, 0.0), (0.0, 0.0, support_n))

        def efforts() -> NDArray[np.float64]:
            q = unwalked()
            found = self._motion_efforts(q, acceleration())
            for hand, force_n in borne.items():
                found -= self._lever(q, hand).T @ force_n
            return found

        return efforts

    def _support_n(self, gripper: FakeGripper) -> float:
        """What something below carries of what a hand holds."""
        if gripper.holding is None or self.world.carried_by(gripper.holding) is None:
            return 0.0
        depth = self.world.pressed_m(gripper.holding)
        return 0.0 if depth is None else SUPPORT_N + SUPPORT_N_M * depth

    def _motion_efforts(self, q: NDArray[np.float64], a: NDArray[np.float64]) -> NDArray[np.float64]:
        """What the motion alone asks for; kept, since a robot that holds asks for the same again."""
        known = self._carried_out
        if known is None or not (np.array_equal(known[0], q) and np.array_equal(known[1], a)):
            known = q, a, self._dynamics.efforts(q, np.zeros(self.model.nv), a)
            self._carried_out = known
        return known[2].copy()

    def _lever(self, q: NDArray[np.float64], hand: Hand) -> NDArray[np.float64]:
        """How a TCP moves with the joints of its arm, m/rad, shape (3, n)."""
        lever = np.zeros((3, len(self.model.joints)))
        columns = [*self.model.group(f"{hand}_arm"), *self.model.group("torso")]
        jacobian = self.model.frame_jacobian(q, self.model.description.tcp_frames[hand])
        lever[:, columns] = jacobian[:3, 6:][:, columns]
        return lever

    def _sense(self) -> Sense:
        """Tells what is felt at this instant, and notes where the robot is then."""
        readings, efforts = self.robot.readings(), self._body_efforts()
        hands_nm = [self.grippers[hand].effort_nm for hand in HANDS]
        self._locate()
        q = self._q

        def felt() -> RobotState:
            return replace(readings(), effort=np.append(efforts(), hands_nm))

        return lambda: SensedState(felt, q.copy)

    def _locate(self) -> None:
        """Note where the robot is, if it may have moved: most of the time it stands and waits."""
        posture, joints = self.motion.posture, self.robot.joints
        if self._told_by is not None and self._told_by[0] is posture and self._told_by[1] is joints:
            return
        self._told_by = posture, joints
        q = posture.copy()
        q[7:] = joints[: len(self.model.joints)]
        if q.tobytes() != self._q.tobytes():
            self._q = q
            self._poses.clear()

    def _pose_of(self, frame: str) -> Transform:
        """A frame's pose; kept, since camera and hands of a robot that holds stay where they are."""
        if frame not in self._poses:
            self._poses[frame] = self.model.frame_pose(self._q, frame)
        return self._poses[frame]


def person(name: str = "Ana", place_m: tuple[float, float] = (1.3, 0.2)) -> TrueObject:
    """A person who faces the robot."""
    turn = poses.rotation_z(np.pi)
    pose = poses.transform(turn, (*place_m, 0.875))
    return TrueObject(name, "person", "person", None, Cylinder(0.24, 1.75), pose)


def bowl(place_m: tuple[float, float] = (0.45, 0.2), table_height_m: float = 0.9) -> TrueObject:
    """A white bowl on the table."""
    pose = poses.translation(*place_m, table_height_m + 0.035)
    return TrueObject("white bowl", "object", "bowl", "white", Cylinder(0.10, 0.07), pose)


def table(name: str = "table", height_m: float = 0.9) -> TrueObject:
    """A table top in front of the robot."""
    pose = poses.translation(0.65, 0.0, height_m - 0.02)
    return TrueObject(name, "furniture", "table", None, Box((0.6, 1.2, 0.04)), pose)


def cup(
    name: str = "red cup",
    color: str = "red",
    place_m: tuple[float, float] = (0.45, -0.2),
    table_height_m: float = 0.9,
) -> TrueObject:
    """A cup of 6 cm by 11 cm on the table."""
    pose = poses.translation(*place_m, table_height_m + 0.055)
    return TrueObject(name, "object", "cup", color, Cylinder(0.03, 0.11), pose)
