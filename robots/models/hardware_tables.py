"""Read what a robot is made of: the tables of ``description.toml`` that planners do not need."""

from __future__ import annotations

from kinematics.model.robot_description import RobotDescription
from robots.interface.hardware import (
    GripSettings,
    Hardware,
    HealthLimits,
    SensorNoise,
    ServoGains,
    WalkingGains,
)
from robots.models.kinds import kind_of
from robots.models.urdf import Table

_GRIP = ("effort_nm", "closing_speed_rad_s", "empty_below_rad", "held_effort_nm")
_BY_KIND = "joint_acceleration"
WALKING_GAINS = frozenset(WalkingGains.__dataclass_fields__)
"""Keys of ``[walking]`` that say how a walk is held upright; the others say what its pattern is."""


def read_hardware(data: Table, description: RobotDescription) -> Hardware:
    """Read the servos, sensors and grips.

    Args:
        data: ``description.toml``.
        description: What was read of it already.

    Raises:
        KeyError: A table or key is missing.
        DescriptionError: A joint belongs to no kind.
    """
    members = data["gains"]["members"]
    gains = {joint: data["gains"][kind_of(joint, members)] for joint in description.actuated}
    contact = data["limits"].get("contact", {})
    return Hardware(
        gains={joint: ServoGains(of["stiffness"], of["damping"]) for joint, of in gains.items()},
        grips={hand: GripSettings(*(data["gripper"][key] for key in _GRIP)) for hand in description.grippers},
        noise=SensorNoise(**data["noise"]),
        contact_effort_nm=_by_joint(contact, description, members),
        walking=_walking(data.get("walking"), description, members),
        health=HealthLimits(**data.get("health", {})),
    )


def _by_joint(by_kind: Table, description: RobotDescription, members: Table) -> dict[str, float]:
    """Numbers of body joints, of those whose kind has one."""
    kinds = {joint: kind_of(joint, members) for joint in description.joints}
    return {joint: by_kind[kind] for joint, kind in kinds.items() if kind in by_kind}


def _walking(data: Table | None, description: RobotDescription, members: Table) -> WalkingGains | None:
    if data is None:
        return None
    numbers = {key: data[key] for key in WALKING_GAINS - {_BY_KIND}}
    return WalkingGains(**numbers, joint_acceleration=_by_joint(data[_BY_KIND], description, members))
