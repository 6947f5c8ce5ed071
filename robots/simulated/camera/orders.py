"""What the process that draws and looks is asked, and what it answers."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from kinematics.arrays import Array, Sealed
from kinematics.geometry.poses import Transform
from robots.perception.detector import PerceptionFrame
from robots.perception.labels.labelling import BY_SHAPE, Labelling
from robots.scenes.light import LightKind
from robots.scenes.scene_description import Furniture, SceneDescription


@dataclass(frozen=True, slots=True)
class LensFaults:
    """What is wrong with a camera beyond its errors.

    Attributes:
        light: Times the scene's light; 0.004 is a dark room.
        glare: Share of the picture, along its upper edge, that a lamp outshines.
        stain: Share of the picture's area under a stain on the lens.
        no_depth: Share of the depths that are missing.
        turn_rad: About the vertical and the lateral axis of the camera: calibration that is wrong.
        flicker: How much exposure changes from picture to picture.
        covered: Nothing is to be seen.
    """

    light: float = 1.0
    glare: float = 0.0
    stain: float = 0.0
    no_depth: float = 0.0
    turn_rad: tuple[float, float] = (0.0, 0.0)
    flicker: float = 0.0
    covered: bool = False


@dataclass(frozen=True, slots=True)
class WorldState(Sealed):
    """Where everything is at one instant, as the simulator has it.

    Attributes:
        qpos: Of all joints, shape (nq,).
        mocap_pos, mocap_quat: Of who walks, shape (n, 3) and (n, 4).
    """

    qpos: Array
    mocap_pos: Array
    mocap_quat: Array


@dataclass(frozen=True, slots=True)
class Setup:
    """What is to be drawn and looked at.

    Attributes:
        robot: Its name.
        scene: Everything else.
        known: The map of the furniture, in the odometry frame.
        seed: Of the camera's errors.
        labelling: Who is asked what things are called.
        slot: Where the newest picture of the robot's own camera is shown to who wants it; None for nowhere.
    """

    robot: str
    scene: SceneDescription
    known: tuple[Furniture, ...]
    seed: int
    labelling: Labelling = BY_SHAPE
    slot: Path | None = None


@dataclass(frozen=True, slots=True)
class Shot(Sealed):
    """One picture that is wanted.

    Attributes:
        stamp_s, sequence: Of the frame.
        state: Where everything really is.
        joints: Where the encoders have the robot's joints, in the order of ``RobotDescription.actuated``.
        odom_T_camera: Where the camera is believed to be, shape (4, 4).
        light: Of the scene.
        faults: Of the camera.
        frozen: Whether the camera gives the picture before once more.
        camera: Which one: 0 is the robot's own, the others are the scene's, in their order from 1.
    """

    stamp_s: float
    sequence: int
    state: WorldState
    joints: Array
    odom_T_camera: Transform
    light: LightKind
    faults: LensFaults
    frozen: bool = False
    camera: int = 0


@dataclass(frozen=True, slots=True)
class Answer:
    """What came of a picture.

    Attributes:
        frame: What was found.
        looked_s: Processor time from picture to detections, beside drawing.
        silence: Why somebody who is asked what things are called could tell nothing; empty else.
    """

    frame: PerceptionFrame
    looked_s: float
    silence: str = ""
