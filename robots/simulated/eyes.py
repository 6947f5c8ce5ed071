"""What a robot sees of a simulated world: by the stub, or by its own camera, as the scene says."""

from __future__ import annotations

from typing import Protocol

import numpy as np

from kinematics.model.robot_model import RobotModel
from robots.clock import Clock
from robots.interface.hardware import RobotData
from robots.interface.sensed_state import SensedState
from robots.perception.detector import Detector
from robots.perception.labels.labelling import BY_SHAPE, Labelling
from robots.perception.stub import PerceptionStub
from robots.perception.stub_faults import StubFaults
from robots.scenes.scene_description import SceneDescription
from robots.simulated.world import SimulatedWorld


class SimulatedPerception(Detector, Protocol):
    """A detector that goes on with the world's control periods, and that can be made to err."""

    @property
    def faults(self) -> StubFaults:
        """Errors beyond those that are declared."""
        ...

    @property
    def silences(self) -> tuple[str, ...]:
        """Why some who were asked what things are called could tell nothing, each reason once."""
        ...

    def tick(self) -> None:
        """One control period has passed."""
        ...

    def set_error(
        self, kind: str, offset_m: tuple[float, float, float], first_look_only: bool = True
    ) -> None:
        """Tell every object of a kind at a wrong place; see ``StubFaults.misplace``."""
        ...


class _Sensing(Protocol):
    def state(self) -> SensedState: ...


def simulated_perception(
    world: SimulatedWorld,
    robot: RobotData,
    scene: SceneDescription,
    clock: Clock,
    rng: np.random.Generator,
    sensing: _Sensing,
    model: RobotModel,
    *,
    waits: bool = True,
    labelling: Labelling = BY_SHAPE,
) -> SimulatedPerception:
    """The perception that a scene asks for.

    Args:
        world: What is looked at.
        robot: Who looks.
        scene: As the world was built from it.
        clock: Simulated time.
        rng: Of the errors.
        sensing: What the robot knows of itself.
        model: The robot's.
        waits: Whether a picture is waited for, as lockstep needs it; live it comes when it is done.
        labelling: Who is asked, of pictures, what things are called.

    Raises:
        DescriptionError: The robot has no camera for pictures.
        RenderingUnavailableError: Nothing can be drawn here.
    """
    if scene.perception.kind == "stub":
        return PerceptionStub(world.truth, robot.description.camera, scene.perception, clock, rng)
    from robots.simulated.camera.camera_perception import Believed, CameraPerception, picture_camera

    frame = picture_camera(robot).frame

    def believed() -> Believed:
        state = sensing.state()
        return Believed(model.frame_pose(state.q, frame), state.readings.q)

    return CameraPerception(
        world.physics, robot, scene, clock, rng, believed, waits=waits, labelling=labelling
    )
