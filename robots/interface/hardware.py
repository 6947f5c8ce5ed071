"""What a body is made of beside its geometry: servos, sensors, grips, and when something is wrong with it.

``kinematics.model.robot_description.RobotDescription`` says where the parts of a robot are and what moves how
fast; planners and the checker need nothing else. What is here is for the control loop and for who simulates
a body. Both are read from one folder, by ``robots.models.description``.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from kinematics.model.robot_description import Hand, RobotDescription
from robots.interface.depth_camera import DepthCamera


@dataclass(frozen=True, slots=True)
class ServoGains:
    """Stiffness (Nm/rad) and damping (Nm s/rad) of a joint's position servo."""

    stiffness: float
    damping: float


@dataclass(frozen=True, slots=True)
class GripSettings:
    """How one gripper closes, and what its sensors say when it holds something.

    Of a joint that slides, positions are metres and efforts newtons where the names say rad and nm.

    Attributes:
        effort_nm: Closing effort used for a grasp; never above the joint's effort limit.
        closing_speed_rad_s: Speed of a guarded closing.
        empty_below_rad: A joint that closed further than this holds nothing.
        held_effort_nm: At least this effort is felt when something is held.
        deadband_rad: A grip follows its fingers only beyond this: far above what encoder noise would stir,
            and, times the servo's stiffness, far below what a grasp feels.
        met_rad: On its way it brakes once it will rest this near: ten times what noise stirs.
        arrived_rad: Fingers this near to where they were sent have arrived; friction and the pads' give leave
            less.
    """

    effort_nm: float
    closing_speed_rad_s: float
    empty_below_rad: float
    held_effort_nm: float
    deadband_rad: float = 0.004
    met_rad: float = 2e-4
    arrived_rad: float = 0.03


@dataclass(frozen=True, slots=True)
class SensorNoise:
    """Standard deviations of the sensors' white noise, SI units, and the encoder resolution.

    Those of an IMU or of feet that the robot does not have are 0.
    """

    joint_position_rad: float
    joint_velocity_rad_s: float
    joint_effort_fraction: float
    gyro_rad_s: float = 0.0
    accelerometer_m_s2: float = 0.0
    foot_force_n: float = 0.0
    foot_torque_nm: float = 0.0


@dataclass(frozen=True, slots=True)
class HealthLimits:
    """From when on something counts as wrong with the body.

    Attributes:
        motor_effort_fraction: A motor that lacks this share of its effort limit, beside what its servo's
            law asks for, is weak or offline.
        stuck_rad: A joint whose setpoint has moved this far within half a second, and which has not
            moved with it, is stuck.
        stuck_effort_nm: A soft joint has to be asked for at least the way that this effort bends its
            servo: so much may what a hand carries or touches hold it back.
        tracking_rad: A joint this far from its setpoint does not follow.
        encoder_offset_rad: A position that has left the sum of the speeds by this.
        gyro_bias_rad_s: Between the gyro and the turning that the legs see.
        foot_force_n: A sole that is meant to carry and feels less has lost the floor.
        foot_error_n: Forces of the floor that are estimated may be wrong by so much: their bounds are wider.
        battery_low: Share of the charge below which no new task is begun.
        late_share: Share of late control periods, over a second, that the loop may have.
        fallen_rad: A base that leans by more has fallen.
    """

    motor_effort_fraction: float = 0.08
    stuck_rad: float = 0.005
    stuck_effort_nm: float = 0.0
    tracking_rad: float = 0.05
    encoder_offset_rad: float = 0.015
    gyro_bias_rad_s: float = 0.01
    foot_force_n: float = 20.0
    foot_error_n: float = 0.0
    battery_low: float = 0.15
    late_share: float = 0.2
    fallen_rad: float = 1.0


@dataclass(frozen=True, slots=True)
class WalkingGains:
    """How a walk is held upright, beside its pattern (``WalkingSettings``).

    Attributes:
        trunk_stiffness_nm, trunk_damping_nms: Moment that rights the trunk, per rad and rad/s.
        ankle_stiffness_nm, ankle_damping_nms: Of the ankles while walking, per rad and rad/s.
        effort_share: Of a joint's effort limit that feed-forward and feedback may ask for.
        joint_acceleration: Limit of the setpoints by joint, rad/s^2, while walking; those that are
            not named keep the limits of other motions.
    """

    trunk_stiffness_nm: float
    trunk_damping_nms: float
    ankle_stiffness_nm: float
    ankle_damping_nms: float
    effort_share: float
    joint_acceleration: Mapping[str, float]


@dataclass(frozen=True, slots=True)
class Hardware:
    """The servos, sensors and grips of one robot.

    Attributes:
        gains: By joint name, grippers too.
        grips: Of each hand that can grasp.
        noise: Of the sensors.
        contact_effort_nm: By joint: more effort than a motion needs, by so much, means contact.
        walking: Of a robot that is known to walk; None for others.
        health: From when on something counts as wrong with the body.
        cameras: Those that see colour and depth; what the first one sees is told in its frame.
    """

    gains: Mapping[str, ServoGains]
    grips: Mapping[Hand, GripSettings]
    noise: SensorNoise
    contact_effort_nm: Mapping[str, float] = field(default_factory=dict)
    walking: WalkingGains | None = None
    health: HealthLimits = field(default_factory=HealthLimits)
    cameras: tuple[DepthCamera, ...] = ()


@dataclass(frozen=True, slots=True)
class RobotData:
    """All that is known of one robot: its geometry, and what it is made of."""

    description: RobotDescription
    hardware: Hardware
