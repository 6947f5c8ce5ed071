"""What a robot sees of a simulated world: by the stub, or by its own camera, as the scene says."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Protocol

import numpy as np

from kinematics.model.robot_model import RobotModel
from robots.clock import Clock
from robots.interface.hardware import RobotData
from robots.interface.sensed_state import SensedState
from robots.perception.detector import Detector
from robots.perception.fusion.cameras import PlacedCamera, calibrated_places
from robots.perception.labels.labelling import BY_SHAPE, Labelling
from robots.perception.stub import PerceptionStub
from robots.perception.stub_faults import StubFaults
from robots.perception.told_labels import told_fronts
from robots.scenes.scene_description import SceneDescription
from robots.simulated.truth.seen_from import SeenFrom
from robots.simulated.world import SimulatedWorld


class SimulatedCamera(Detector, Protocol):
    """A detector that can be made to err."""

    @property
    def faults(self) -> StubFaults:
        """Errors beyond those that are declared."""
        ...

    def set_error(
        self, kind: str, offset_m: tuple[float, float, float], first_look_only: bool = True
    ) -> None:
        """Tell every object of a kind at a wrong place; see ``StubFaults.misplace``."""
        ...


class SimulatedPerception(SimulatedCamera, Protocol):
    """The robot's own camera; it goes on with the world's control periods, and others with it."""

    @property
    def cameras(self) -> Sequence[SimulatedCamera]:
        """Those that stand in the room, in the scene's order."""
        ...

    @property
    def silences(self) -> tuple[str, ...]:
        """Why some who were asked what things are called could tell nothing, each reason once."""
        ...

    def tick(self) -> None:
        """One control period has passed."""
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
    slot: Path | None = None,
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
        slot: Where the newest picture of the robot's own camera is shown to who wants it; None for nowhere.

    Raises:
        DescriptionError: The robot has no camera for pictures.
        RenderingUnavailableError: Nothing can be drawn here.
    """
    if scene.perception.kind == "stub":
        return _stub(world, robot, scene, clock, rng)
    from robots.simulated.camera.camera_perception import CameraPerception, picture_camera
    from robots.simulated.camera.feed import Believed

    frame = picture_camera(robot).frame

    def believed() -> Believed:
        state = sensing.state()
        return Believed(model.frame_pose(state.q, frame), state.readings.q)

    return CameraPerception(
        world.physics, robot, scene, clock, rng, believed, waits=waits, labelling=labelling, slot=slot
    )


def _stub(
    world: SimulatedWorld,
    robot: RobotData,
    scene: SceneDescription,
    clock: Clock,
    rng: np.random.Generator,
) -> PerceptionStub:
    """The stub for the robot's own camera, and one for each that stands in the room."""
    fronts = told_fronts(scene.furniture)
    own = PerceptionStub(world.truth, robot.description.camera, scene.perception, clock, rng, fronts)
    own.cameras = tuple(
        PerceptionStub(
            SeenFrom(world.truth, camera.world_T_camera),
            replace(
                robot.description.camera,
                horizontal_fov_rad=camera.field_of_view_rad[0],
                vertical_fov_rad=camera.field_of_view_rad[1],
                range_m=camera.range_m,
            ),
            replace(scene.perception, rate_hz=camera.rate_hz, latency_s=camera.latency_s),
            clock,
            chance,
            fronts,
        )
        for camera, chance in zip(scene.cameras, rng.spawn(len(scene.cameras)), strict=True)
    )
    return own


def placed_cameras(perception: SimulatedPerception, scene: SceneDescription) -> tuple[PlacedCamera, ...]:
    """The cameras that stand in the room, as whoever looks through them needs them.

    Args:
        perception: That of the scene.
        scene: Where they are.
    """
    return tuple(
        PlacedCamera(camera.name, detector, place, camera.field_of_view_rad, camera.range_m)
        for camera, detector, place in zip(
            scene.cameras, perception.cameras, calibrated_places(scene), strict=True
        )
    )
