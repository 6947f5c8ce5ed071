"""What is known about a robot as data, before any library has seen it.

``robots.models.description`` reads it from ``robots/models/<name>/description.toml``; everything
that is true of one robot and not of robots in general belongs there.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

from kinematics.errors import MissingPartError
from kinematics.model.camera_description import CameraDescription
from kinematics.model.handle_settings import (
    AS_IT_OPENS,
    FAR_REACH,
    PADS_ON_A_BAR,
    BarGrip,
    HandleStanding,
    Pushing,
)
from kinematics.model.walking_settings import WalkingSettings

if TYPE_CHECKING:  # numpy comes with it, and the names of hands are asked for by who only reads a sentence
    from kinematics.model.reachability import ReachabilityMap

Hand = Literal["left", "right"]
HANDS: tuple[Hand, Hand] = ("left", "right")
"""The names of hands; a robot's own are ``RobotDescription.hands``, perhaps only one of them."""

Base = Literal["floating", "welded"]
"""What holds a robot up: its feet, or bolts."""

GROUPS = ("left_leg", "right_leg", "torso", "left_arm", "right_arm", "head")
"""The groups of joints that every robot has, some of them empty."""


@dataclass(frozen=True, slots=True)
class JointLimits:
    """Limits of one joint, SI units; ``position`` in rad, (lower, upper)."""

    position: tuple[float, float]
    velocity: float
    acceleration: float
    jerk: float
    effort: float


@dataclass(frozen=True, slots=True)
class HandMotor:
    """One of the motors of a hand that has several.

    Attributes:
        joint: The joint that it drives.
        open_rad, closed_rad: Where that is when the hand is fully open and fully closed.
    """

    joint: str
    open_rad: float
    closed_rad: float


def _looked_up(table: tuple[tuple[float, float], ...], at: float) -> float:
    """Linearly between the pairs of a table, beyond it as at its nearer end; 0 of none."""
    if not table:
        return 0.0
    low, high = table[0], table[-1]
    for row in table:
        if row[0] >= at:
            high = row
            break
        low = row
    if low[0] >= at or high[0] <= low[0]:
        return low[1]
    share = min(1.0, (at - low[0]) / (high[0] - low[0]))
    return low[1] + share * (high[1] - low[1])


@dataclass(frozen=True, slots=True)
class GripperDescription:
    """One gripper.

    Its position is that of its one driven joint; or, of a hand of several motors, how far it is open, from 0
    (closed) to 1: each motor goes the straight way between its two ends (a synergy), and where things hold
    them back, the position is their mean. Of a joint that slides, positions are metres and efforts newtons
    where the names say rad and nm.

    Attributes:
        hand: Which hand it is.
        joint: The one driven joint, which others may mimic; of several motors the first that moves.
        tcp_frame: Frame with x along the approach, y along the opening, origin between the pads.
        base_link: Link that the fingers hang on.
        links: Every link of the gripper; they may touch each other.
        touch_links: Links that may touch an object while it is grasped.
        open_rad, closed_rad: Joint positions, fully open and fully closed.
        opening_table: Pairs (joint rad, opening between the pads m), rising in joint position.
        payload_kg: The heaviest that arm and hand are made to carry; nothing held is taken for heavier.
        pad_links: Fingertip links, each with one pad.
        pad_half_size_m: Half-sizes of each pad (across, thickness, length), in the order of ``pad_links``.
        pad_position_m: Centre of each pad in the frame of its fingertip link, in that order.
        pad_gap_m: Between neighbouring pads of one side, across the approach: what is round about the
            approach sinks in between them.
        palm_distance_m: From the TCP back to the palm, along the approach.
        closing_advance_m: How much farther the fingertips reach along the approach when they close.
        palm_gap_m: What the palm keeps from what is grasped.
        tip_gap_m: Pointing down, the TCP stays this far above the foot of what it grasps: fingertips reach
            beyond it, and farther as they close.
        low_tip_gap_m, low_tilt_gap_m: The same over what is low, or a ball, whose sides are to be between the
            pads; and how much more a hand needs that is not tilted at all.
        lowest_overlap_m: The TCP is at least so far below the top of something low; negative: above it.
        pad_overlap_m: The same of what is not low.
        slides: Whether the driven joint slides.
        over_ball_m: No farther above a ball's middle than this: its sides would be at the edges of the pads.
        motors: The motors of a hand that has several.
        palm_side_m: Where along the opening the palm is that the fingers press a thing against; None of
            fingers that centre it between them.
        beside_palm_m: What a thing is away from that palm when the fingers begin to close.
        held_table: Pairs (width m, where along the opening its middle is once held m) of such a hand, rising
            in width; empty of all others.
        push_table: The same of where along the fingers a thing is at least once they have opened, m; empty of
            fingers that leave it where it stands.
        aside_table: The same of how far along the opening it goes meanwhile, m.
        felt_n: Lift of the hand that says that what it holds stands on something: more than its arm's motors
            show while nothing is there.
        least_felt_m: What is thinner between the pads cannot be told from an empty hand.
        fingers_half_width_m: From the middle of the fingers of one side to their edge, across the approach.
        side_overlap_m: From the side, the TCP is at least so far below the top of what it grasps: all
            fingers are to meet it.
        above_middle: From the side, the TCP is usually so far above the middle of what it grasps, as a share
            of its height: the hand keeps off what it stands on, and it hangs stably,
        side_gap_m: but no nearer to its foot than this, where its height allows that.
        steepest_rad: No grasp is tilted down by more than this.
        around_m: What is deeper along the fingers they do not close around; infinite for pads.
        bar: How it takes hold of a bar.
        cannot_grip_bars: Why the hand takes hold of no handle; empty when it can.
    """

    hand: Hand
    joint: str
    tcp_frame: str
    base_link: str
    links: tuple[str, ...]
    touch_links: tuple[str, ...]
    pad_links: tuple[str, ...]
    open_rad: float
    closed_rad: float
    opening_table: tuple[tuple[float, float], ...]
    payload_kg: float
    pad_half_size_m: tuple[tuple[float, float, float], ...]
    pad_position_m: tuple[tuple[float, float, float], ...]
    pad_gap_m: float
    palm_distance_m: float
    closing_advance_m: float
    palm_gap_m: float = 0.012
    tip_gap_m: float = 0.057
    low_tip_gap_m: float = 0.053
    low_tilt_gap_m: float = 0.045
    lowest_overlap_m: float = -0.014
    pad_overlap_m: float = 0.02
    over_ball_m: float = 0.032
    slides: bool = False
    motors: tuple[HandMotor, ...] = ()
    palm_side_m: float | None = None
    beside_palm_m: float = 0.0
    held_table: tuple[tuple[float, float], ...] = ()
    push_table: tuple[tuple[float, float], ...] = ()
    aside_table: tuple[tuple[float, float], ...] = ()
    felt_n: float = 6.0
    least_felt_m: float = 0.02
    fingers_half_width_m: float = 0.05
    side_overlap_m: float = -math.inf
    above_middle: float = 0.12
    side_gap_m: float = 0.0
    steepest_rad: float = math.pi / 2
    around_m: float = math.inf
    bar: BarGrip = PADS_ON_A_BAR
    cannot_grip_bars: str = ""

    @property
    def joints(self) -> tuple[str, ...]:
        """The driven joints."""
        return tuple(motor.joint for motor in self.motors) or (self.joint,)

    @property
    def moving(self) -> tuple[HandMotor, ...]:
        """Those motors of several that are not held where they are."""
        return tuple(motor for motor in self.motors if motor.open_rad != motor.closed_rad)

    def joints_at(self, position: float) -> tuple[float, ...]:
        """Where the driven joints are with the gripper at a position."""
        if not self.motors:
            return (position,)
        return tuple(
            motor.closed_rad + position * (motor.open_rad - motor.closed_rad) for motor in self.motors
        )

    def position_of(self, joints: Mapping[str, float]) -> float:
        """The position of the gripper whose driven joints are somewhere, by name."""
        if not self.motors:
            return joints[self.joint]
        shares = [
            (joints[motor.joint] - motor.closed_rad) / (motor.open_rad - motor.closed_rad)
            for motor in self.moving
        ]
        return sum(shares) / len(shares)

    def grasped_at_m(self, width_m: float) -> float:
        """Where along the opening, from the TCP, the middle of a thing is to be when the fingers close on it.

        Args:
            width_m: Of the thing, along the opening.
        """
        if self.palm_side_m is None:
            return 0.0
        return self.palm_side_m - math.copysign(0.5 * width_m + self.beside_palm_m, self.palm_side_m)

    def held_at_m(self, width_m: float) -> float:
        """The same once they have closed; beyond the table as at its nearer end."""
        return _looked_up(self.held_table, width_m)

    def pushed_m(self, width_m: float, from_m: float) -> tuple[float, float]:
        """How far a thing goes along the fingers and along the opening when they open.

        Args:
            width_m: Of the thing; beyond the tables as at their nearer ends.
            from_m: Where along the fingers it is, from the TCP.
        """
        ahead_m = max(0.0, _looked_up(self.push_table, width_m) - from_m) if self.push_table else 0.0
        return ahead_m, _looked_up(self.aside_table, width_m)

    @property
    def finger_links(self) -> tuple[str, ...]:
        """Every link of the gripper but the one that the fingers hang on: the palm."""
        return tuple(link for link in self.links if link != self.base_link)

    def position_at(self, opening_m: float) -> float:
        """Where the gripper is when its pads are so far apart; beyond the table at the nearer end of it."""
        return _looked_up(tuple(sorted((wide, at) for at, wide in self.opening_table)), opening_m)

    @property
    def max_opening_m(self) -> float:
        """Opening with the fingers fully apart."""
        return max(opening for _, opening in self.opening_table)


@dataclass(frozen=True, slots=True)
class SoleDescription:
    """A sole: its frame (z up when flat) and the rectangle that carries, in that frame."""

    side: Hand
    frame: str
    link: str
    x_m: tuple[float, float]
    y_m: tuple[float, float]
    thickness_m: float


@dataclass(frozen=True, slots=True)
class RobotDescription:
    """What planners and the checker know about one robot: where its parts are, and what moves how fast.

    Its servos, sensors and health limits are ``robots.interface.hardware``.

    Attributes:
        name: Folder name under ``robots/models``.
        urdf: Cleaned URDF text with the TCP links added and mesh paths absolute, grippers moving.
        planning_urdf: The same with the gripper joints fixed open.
        disabled_collisions: Pairs of links that are never checked against each other.
        joints: Actuated body joints, in Pinocchio's order of the planning model.
        gripper_joints: Driven gripper joints, appended after ``joints`` in every setpoint.
        limits: By joint name, grippers too.
        armature: Reflected rotor inertia by joint name, kg m^2, grippers too.
        home: Joint positions of the home posture, every joint.
        groups: Joint names by group, every one of ``GROUPS``; empty where the robot has no such part.
        grippers: Of the hands that can grasp.
        soles: What it stands on; empty when the base is welded.
        tcp_frames: TCP of each hand, grasping or not: x along the approach, y along the opening.
        head_camera: The camera that the robot goes by, if there is one.
        imu: Link of the IMU, if there is one.
        base: What holds the robot up.
        mount_xyz_m, mount_rpy_rad: Pose of a welded base in the odometry frame, whose floor is z = 0;
            roll, pitch, yaw about fixed axes.
        cannot_grasp: Why hands without a gripper have none; empty when all can grasp.
        walking: How it walks; None for a robot that does not, or of which it is not known.
        joint_viscosity_nms_rad: Effort that each rad/s of a joint loses to its friction.
        reachability: How well the hands reach what is around; None where nobody has made the map.
        planning_margin_rad: Limits are shrunk by this for planning.
        com_margin_m: The CoM's projection stays at least this far inside the support polygon.
        reach_m: No hand gets farther than this from its shoulder, a trunk that leans included.
        lean_rad: To reach something the pelvis leans forward or back by no more, aside by two thirds.
        foot_sensors: Whether its feet feel what the floor does; else the legs' efforts tell it.
        handles: Where it stands to open and close things.
        pushing: How it pushes shut what is open.
    """

    name: str
    urdf: str
    planning_urdf: str
    mesh_dir: str
    disabled_collisions: frozenset[tuple[str, str]]
    joints: tuple[str, ...]
    gripper_joints: tuple[str, ...]
    limits: Mapping[str, JointLimits]
    armature: Mapping[str, float]
    home: Mapping[str, float]
    groups: Mapping[str, tuple[str, ...]]
    grippers: Mapping[Hand, GripperDescription]
    soles: tuple[SoleDescription, ...]
    tcp_frames: Mapping[Hand, str]
    head_camera: CameraDescription | None
    base_link: str
    imu: str | None
    planning_margin_rad: float
    com_margin_m: float
    base: Base = "floating"
    mount_xyz_m: tuple[float, float, float] = (0.0, 0.0, 0.0)
    mount_rpy_rad: tuple[float, float, float] = (0.0, 0.0, 0.0)
    cannot_grasp: str = ""
    walking: WalkingSettings | None = None
    reachability: ReachabilityMap | None = None
    joint_viscosity_nms_rad: float = 0.0
    reach_m: float = 1.15
    lean_rad: float = 0.9
    foot_sensors: bool = True
    handles: HandleStanding = FAR_REACH
    pushing: Pushing = AS_IT_OPENS

    @property
    def actuated(self) -> tuple[str, ...]:
        """Joint names of a setpoint: body joints, then gripper joints."""
        return self.joints + self.gripper_joints

    @property
    def hands(self) -> tuple[Hand, ...]:
        """The hands that the robot has, left before right."""
        return tuple(hand for hand in HANDS if hand in self.tcp_frames)

    @property
    def welded(self) -> bool:
        """Whether the base is bolted to something: no stance, nothing to balance."""
        return self.base == "welded"

    @property
    def camera(self) -> CameraDescription:
        """The camera that the robot goes by.

        Raises:
            MissingPartError: The robot has none.
        """
        if self.head_camera is None:
            raise MissingPartError(self.name, "camera")
        return self.head_camera

    @property
    def imu_link(self) -> str:
        """Link of the IMU.

        Raises:
            MissingPartError: The robot has none.
        """
        if self.imu is None:
            raise MissingPartError(self.name, "IMU")
        return self.imu

    @property
    def missing_for_tasks(self) -> tuple[str, ...]:
        """What every task needs and this robot does not have; what single skills need, their records say."""
        return () if self.head_camera is not None else ("camera",)

    @property
    def gripping_hands(self) -> tuple[Hand, ...]:
        """The hands that can grasp, left before right."""
        return tuple(hand for hand in HANDS if hand in self.grippers)

    @property
    def arms(self) -> tuple[Hand, ...]:
        """The sides that have an arm, left before right."""
        return tuple(hand for hand in HANDS if self.groups[f"{hand}_arm"])
