"""Where a served robot is: in a simulated world, or wherever its body is."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Protocol

import numpy as np

from kinematics.model.robot_model import RobotModel
from robots.clock import Clock, WallClock
from robots.interface.bodies import body_named
from robots.interface.hardware import RobotData
from robots.interface.robot import Robot
from robots.interface.sensed_state import SensedState
from robots.perception.detector import Detector, RangeSensor
from robots.perception.fusion.cameras import PlacedCamera
from robots.perception.labels.labelling import Labelling
from robots.perception.no_eyes import NoEyes
from robots.scenes.scene_description import SceneDescription
from robots.seeded import Seeded
from robots.simulated.eyes import placed_cameras, simulated_perception
from robots.simulated.world import build_world


class Sensing(Protocol):
    """What a control loop knows of its robot."""

    def state(self) -> SensedState:
        """The newest of it."""
        ...


@dataclass(frozen=True, slots=True)
class Sight:
    """What is seen from a robot.

    Attributes:
        detector: Its own camera.
        tick: One control period has passed.
        ranging: Distances all around, or None.
        cameras: Those that stand in the room.
        on_offer: Called when something is held out, with whom it is for.
    """

    detector: Detector
    tick: Callable[[], None] = lambda: None
    ranging: RangeSensor | None = None
    cameras: Sequence[PlacedCamera] = ()
    on_offer: Callable[[str], None] = lambda _person: None


class Site(Protocol):
    """A place with a robot in it.

    Attributes:
        robot: Its body.
        kind: How it sees: "stub", "rgbd", "none".
        time_passes: Whether time passes by itself there, and ``advance`` waits for it.
    """

    robot: Robot
    kind: str
    time_passes: bool

    def sight(self, sensing: Sensing, model: RobotModel) -> Sight:
        """What is seen from the robot, once its control loop knows where it stands."""
        ...

    def truth(self) -> dict[str, Any]:
        """What really is the case, for evaluations; empty where nobody knows."""
        ...


class SimulatedSite:
    """A simulated world.

    Args:
        robot: Whose body is in it.
        scene: Everything else.
        clock: Control time.
        chance: Of everything random.
        shown: Folder of things that were shown; None for none.
        slot: Where the newest picture is shown to who wants it.

    Raises:
        RobotsError: The robot cannot stand there.
    """

    time_passes = False

    def __init__(
        self,
        robot: RobotData,
        scene: SceneDescription,
        clock: Clock,
        chance: Seeded,
        shown: Path | None,
        slot: Path,
    ) -> None:
        self._data, self._scene, self._clock, self._chance = robot, scene, clock, chance
        self._shown, self._slot = shown, slot
        self._world = build_world(robot, scene, chance.world)
        self.robot: Robot = self._world.robot
        self.kind = scene.perception.kind

    def sight(self, sensing: Sensing, model: RobotModel) -> Sight:
        """By the stub or by the camera, as the scene says."""
        world, scene = self._world, self._scene
        perception = simulated_perception(
            world,
            self._data,
            scene,
            self._clock,
            self._chance.perception,
            sensing,
            model,
            waits=False,
            labelling=Labelling(self._shown, packages=True, words=scene.perception.labels),
            slot=self._slot,
        )
        cameras = placed_cameras(perception, scene)
        return Sight(perception, perception.tick, world.ranging, cameras, world.people.see_offer)

    def truth(self) -> dict[str, Any]:
        """The simulator's."""
        truth, physics = self._world.truth, self._world.physics
        return {
            "t_s": self._clock.now_s(),
            "fallen": truth.fallen(),
            "com_margin_m": truth.com_margin_m(),
            "speed_rad_s": float(np.abs(physics.data.qvel[physics.joint_qvel]).max()),
            "lift_m": {name: truth.lift_m(name) for name in truth.objects()},
            "base": truth.world_T_base().tolist(),
            "places_m": {name: truth.world_T_object(name)[:3, 3].tolist() for name in truth.objects()},
        }


class BodySite:
    """Wherever a body is that is not simulated. It brings no eyes.

    Args:
        robot: Its data.
        body: How it is attached, by the name of its entry point.
        options: Its own.

    Raises:
        BodyError: There is no such body, it lacks a library, or an option is wrong.
        RobotsError: Nobody answers.
    """

    time_passes, kind = True, "none"

    def __init__(self, robot: RobotData, body: str, options: Mapping[str, str]) -> None:
        self.robot = body_named(body)(robot, WallClock(), options)

    def sight(self, sensing: Sensing, model: RobotModel) -> Sight:  # noqa: ARG002
        """Nothing."""
        return Sight(NoEyes())

    def truth(self) -> dict[str, Any]:
        """Nobody knows it."""
        return {}
