"""A robot on an empty floor with its control loop alone: no tree, no perception."""

from __future__ import annotations

import math

import numpy as np

from kinematics.model.robot_model import RobotModel
from kinematics.model.walking_settings import WalkingSettings
from kinematics.walking.pattern.steering import VelocitySteering
from robots.clock import ManualClock
from robots.control.loop.control_loop import ControlLoop
from robots.control.motion_handle import MotionHandle
from robots.models.description import load_robot
from robots.scenes.scene_description import Furniture, RobotStart, SceneDescription
from robots.simulated.world import SimulatedWorld, build_world

PERIOD_S = 0.002
STILL_M_S = 0.02
_STANDS_WITHIN_S = 4.0


class BareWalk:
    """Stands and walks; somebody else disturbs.

    Attributes:
        world: The simulator.
        loop: The control loop.
        events: All that it told.
        settings: How the robot walks.
        torso: The link that its trunk ends in.
    """

    def __init__(
        self, robot: str, seed: int, plates: tuple[Furniture, ...] = (), delay_periods: int = 0
    ) -> None:
        """Stand on the floor.

        Args:
            robot: Its name.
            seed: Of the sensors' noise.
            plates: What lies on the floor.
            delay_periods: How late its sensors are.

        Raises:
            ValueError: The robot is not known to walk.
        """
        data = load_robot(robot)
        description = data.description
        if description.walking is None:
            raise ValueError(f"{robot} is not known to walk")
        self.settings: WalkingSettings = description.walking
        scene = SceneDescription("floor", RobotStart(), furniture=plates)
        self.world: SimulatedWorld = build_world(data, scene, np.random.default_rng(seed))
        self.world.body_faults.delay_sensors(delay_periods)
        self.events: list[object] = []
        model = RobotModel(description)
        self.torso = model.moved_links[description.groups["torso"][-1]]
        self.loop = ControlLoop(self.world.robot, model, ManualClock(), self.events.append, PERIOD_S)

    def go_on(self, seconds: float) -> bool:
        """Let time pass; False as soon as the robot has fallen."""
        for k in range(round(seconds / PERIOD_S)):
            if k % 10 == 0 and self.world.truth.fallen():
                return False
            self.loop.step()
        return not self.world.truth.fallen()

    def set_out(self, linear_m_s: float, angular_rad_s: float) -> MotionHandle:
        """Begin to walk at a velocity."""
        return self.loop.walking.walk(VelocitySteering(self.settings, linear_m_s, angular_rad_s), "walk")

    def stands_again(self, handle: MotionHandle) -> bool:
        """Stop, and tell whether the robot stands still afterwards."""
        self.loop.walking.finish(handle)
        for _ in range(round(_STANDS_WITHIN_S / PERIOD_S)):
            if not self.loop.walking.active:
                break
            if not self.go_on(PERIOD_S):
                return False
        return self.go_on(0.5) and self.still()

    def still(self) -> bool:
        """Whether the base is at rest, by its way in a tenth of a second."""
        before = self.world.truth.world_T_base()[:3, 3].copy()
        if not self.go_on(0.1):
            return False
        way_m = float(np.linalg.norm(self.world.truth.world_T_base()[:3, 3] - before))
        return way_m / 0.1 < STILL_M_S

    def push(self, force_n: float, angle_rad: float, link: str, duration_s: float = 0.1) -> bool:
        """Push a link for a while, in a direction seen from the robot; False when it has fallen."""
        world = self.world
        base = world.truth.world_T_base()
        heading = math.atan2(base[1, 0], base[0, 0]) + angle_rad
        force = force_n * np.array([math.cos(heading), math.sin(heading), 0.0])
        pushed = world.physics.data.xfrc_applied[world.physics.body_id(link)]
        pushed[:3] = force
        stands = self.go_on(duration_s)
        pushed[:3] = 0.0
        return stands
