"""What a robot is made of, from the tables of ``description.toml`` that planners do not need."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from kinematics.model.robot_description import RobotDescription
from robots.interface.hardware import GripSettings, Hardware, ServoGains
from robots.models.description_document import DescriptionDocument

_CONTACT = 0.2
"""Of the effort of an arm's joint: beyond what a motion needs that means contact, where nothing is said. G1's
joints gave up to 0.12 beyond in motions, and 0.15 in walks, where more is allowed."""


def hardware_of(document: DescriptionDocument, description: RobotDescription) -> Hardware:
    """The servos, sensors and grips.

    Args:
        document: ``description.toml``.
        description: What was made of it already.

    Raises:
        DescriptionError: A joint belongs to no kind, or to one without gains.
    """
    kinds = {joint: document.gains.kind_of(joint) for joint in description.joints}

    def by_joint(numbers: Mapping[str, float]) -> dict[str, float]:
        return {joint: numbers[kind] for joint, kind in kinds.items() if kind in numbers}

    servos = {joint: document.gains.of(joint) for joint in description.actuated}
    walking, gripper = document.walking, document.gripper
    gains = None if walking is None else walking[1]
    return Hardware(
        gains={joint: ServoGains(servo.stiffness, servo.damping) for joint, servo in servos.items()},
        grips={}
        if gripper is None
        else {
            hand: GripSettings(
                gripper.effort_nm,
                gripper.closing_speed_rad_s,
                gripper.empty_below_rad,
                gripper.held_effort_nm,
                gripper.deadband_rad,
                gripper.met_rad,
                gripper.arrived_rad,
            )
            for hand in description.grippers
        },
        noise=document.noise,
        contact_effort_nm=by_joint(document.limits.contact) or _usual_contact(description),
        walking=None
        if gains is None
        else replace(gains, joint_acceleration=by_joint(gains.joint_acceleration)),
        health=document.health,
        cameras=tuple(document.rgbd),
    )


def _usual_contact(description: RobotDescription) -> dict[str, float]:
    joints = [joint for hand in description.arms for joint in description.groups[f"{hand}_arm"]]
    return {joint: _CONTACT * description.limits[joint].effort for joint in joints}
