"""What ``description.toml`` may say, key by key; ``docs/extend/a-robot.md`` tells what it means."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from typing import Annotated, Literal, TypeVar

from pydantic import AfterValidator, BaseModel, ConfigDict, Field, FiniteFloat

from kinematics.model.camera_description import CameraDescription
from kinematics.model.handle_settings import (
    AS_IT_OPENS,
    FAR_REACH,
    PADS_ON_A_BAR,
    BarGrip,
    HandleStanding,
    Pushing,
)
from kinematics.model.robot_description import Hand, SoleDescription
from kinematics.model.walking_settings import WalkingSettings
from robots.errors import DescriptionError
from robots.interface.depth_camera import DepthCamera
from robots.interface.hardware import HealthLimits, SensorNoise, WalkingGains
from robots.models.usual_scene import USUAL_SCENE
from robots.strict_table import AsTable, Pair, StrictTable, Text, Triple, said

Of = TypeVar("Of")
Numbers = dict[str, FiniteFloat]
"""By joint, or by kind of joint."""


def _pattern(text: str) -> str:
    try:
        re.compile(text)
    except re.error as broken:
        raise said(f"{text!r} is no regular expression: {broken}") from broken
    return text


class SourceTable(StrictTable):
    """``[source]``: whose URDF it is."""

    distribution: Text | None = None
    root: Text = "."
    urdf: Text
    srdf: Text | None = None
    srdf_posture: Text | None = None
    capsules_as_cylinders: bool = False


class BodyTable(StrictTable):
    """``[body]``."""

    base_link: Text
    imu_link: Text | None = None
    base: Literal["floating", "welded"] = "floating"
    mount_xyz_m: Triple = (0.0, 0.0, 0.0)
    mount_rpy_rad: Triple = (0.0, 0.0, 0.0)
    reach_m: FiniteFloat = 1.15
    foot_sensors: bool = True
    scene: Text = USUAL_SCENE


class LimitsTable(StrictTable):
    """``[limits]``: by kind of joint, positions by joint."""

    planning_margin_rad: FiniteFloat
    com_margin_m: FiniteFloat | None = None
    lean_rad: FiniteFloat = 0.9
    acceleration: Numbers
    jerk: Numbers
    velocity: Numbers = Field(default_factory=dict)
    effort: Numbers = Field(default_factory=dict)
    contact: Numbers = Field(default_factory=dict)
    position: dict[str, Pair] = Field(default_factory=dict)


class GainTable(StrictTable):
    """The servos of one kind of joint."""

    stiffness: FiniteFloat
    damping: FiniteFloat
    armature: FiniteFloat


class GainsTable(BaseModel):
    """``[gains]``: a table for each kind of joint, whatever it is called, and which joints are of it."""

    model_config = ConfigDict(strict=True, extra="allow", allow_inf_nan=False, frozen=True, defer_build=True)
    __pydantic_extra__: dict[str, GainTable]

    members: dict[str, Annotated[str, AfterValidator(_pattern)]]

    def kind_of(self, joint: str) -> str:
        """The kind of a joint: the first whose pattern fits.

        Raises:
            DescriptionError: It belongs to none.
        """
        for kind, pattern in self.members.items():
            if re.fullmatch(pattern, joint):
                return kind
        raise DescriptionError(f"joint {joint!r} belongs to no kind of [gains.members]")

    def of(self, joint: str) -> GainTable:
        """The servo of a joint.

        Raises:
            DescriptionError: Its kind has none.
        """
        return by_kind(self.__pydantic_extra__, self.kind_of(joint), "gains")


def by_kind(table: Mapping[str, Of], kind: str, name: str) -> Of:
    """What a table says of a kind of joint.

    Raises:
        DescriptionError: Nothing.
    """
    if kind not in table:
        raise DescriptionError(f"[{name}] says nothing of the kind {kind!r} of [gains.members]")
    return table[kind]


class PlaceTable(StrictTable):
    """Where something is on its link."""

    xyz: Triple = (0.0, 0.0, 0.0)
    rpy: Triple = (0.0, 0.0, 0.0)


class TcpTable(StrictTable):
    """The TCPs of the hands that there are."""

    frame: Text
    left: PlaceTable | None = None
    right: PlaceTable | None = None

    def places(self) -> dict[Hand, PlaceTable]:
        """By hand, left before right."""
        hands: dict[Hand, PlaceTable | None] = {"left": self.left, "right": self.right}
        return {hand: place for hand, place in hands.items() if place is not None}


class HandTable(StrictTable):
    """``[hand]``: hands that only reach."""

    base_link: Text
    tcp: TcpTable
    cannot_grasp: str = ""


class MotorTable(StrictTable):
    """``[[gripper.motor]]``: one of several, of the left hand; a mirrored right one turns the other way."""

    joint: Text
    open_rad: FiniteFloat
    closed_rad: FiniteFloat
    effort_nm: FiniteFloat
    mirrored: bool = False


class GripperTable(StrictTable):
    """``[gripper]``: hands that grasp, with one driven joint or with several motors."""

    joint: Text | None = None
    motor: list[MotorTable] = Field(default_factory=list)
    base_link: Text
    tcp: TcpTable
    links: list[Text]
    cluster: list[Text] = Field(default_factory=list)
    touch_links: list[Text]
    pad_links: list[Text]
    open_rad: FiniteFloat
    closed_rad: FiniteFloat
    opening_table: list[Pair]
    effort_nm: FiniteFloat
    closing_speed_rad_s: FiniteFloat
    empty_below_rad: FiniteFloat
    held_effort_nm: FiniteFloat
    payload_kg: FiniteFloat
    pad_half_size_m: list[Triple]
    pad_position_m: list[Triple]
    mirrored_pads: bool = False
    pad_gap_m: FiniteFloat
    palm_distance_m: FiniteFloat
    closing_advance_m: FiniteFloat
    palm_gap_m: FiniteFloat = 0.012
    tip_gap_m: FiniteFloat = 0.057
    low_tip_gap_m: FiniteFloat = 0.053
    low_tilt_gap_m: FiniteFloat = 0.045
    lowest_overlap_m: FiniteFloat = -0.014
    pad_overlap_m: FiniteFloat = 0.02
    over_ball_m: FiniteFloat = 0.032
    palm_side_m: FiniteFloat | None = None
    beside_palm_m: FiniteFloat = 0.0
    held_table: list[Pair] = Field(default_factory=list)
    push_table: list[Pair] = Field(default_factory=list)
    aside_table: list[Pair] = Field(default_factory=list)
    felt_n: FiniteFloat = 6.0
    least_felt_m: FiniteFloat = 0.02
    fingers_half_width_m: FiniteFloat = 0.05
    side_overlap_m: FiniteFloat | None = None
    above_middle: FiniteFloat = 0.12
    side_gap_m: FiniteFloat = 0.0
    steepest_rad: FiniteFloat = math.pi / 2
    around_m: FiniteFloat | None = None
    bar: Annotated[BarGrip, AsTable()] = PADS_ON_A_BAR
    cannot_grip_bars: str = ""
    deadband_rad: FiniteFloat = 0.004
    met_rad: FiniteFloat = 2e-4
    arrived_rad: FiniteFloat = 0.03


class FrameTable(PlaceTable):
    """``[[frame]]``: one more frame on a link."""

    name: Text
    link: Text


class CollisionTable(PlaceTable):
    """``[[collision]]``: one more box for a link."""

    link: Text
    size_m: Triple
    drawn: bool = False
    instead: bool = False


class FrictionTable(StrictTable):
    """``[friction]``."""

    viscosity_nms_rad: FiniteFloat = 0.0


class DescriptionDocument(StrictTable):
    """The whole file."""

    source: SourceTable
    body: BodyTable
    groups: dict[str, list[Text]]
    home: Numbers
    held: Numbers = Field(default_factory=dict)
    limits: LimitsTable
    gains: GainsTable
    gripper: GripperTable | None = None
    hand: HandTable | None = None
    frame: list[FrameTable] = Field(default_factory=list)
    collision: list[CollisionTable] = Field(default_factory=list)
    sole: list[Annotated[SoleDescription, AsTable()]] = Field(default_factory=list)
    camera: Annotated[CameraDescription, AsTable()] | None = None
    noise: Annotated[SensorNoise, AsTable()]
    friction: FrictionTable = FrictionTable()
    walking: Annotated[tuple[WalkingSettings, WalkingGains], AsTable()] | None = None
    handles: Annotated[HandleStanding, AsTable()] = FAR_REACH
    pushing: Annotated[Pushing, AsTable()] = AS_IT_OPENS
    health: Annotated[HealthLimits, AsTable()] = HealthLimits()
    rgbd: list[Annotated[DepthCamera, AsTable()]] = Field(default_factory=list)
