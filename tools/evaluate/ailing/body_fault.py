"""Faults of the body: what breaks, and as what it has to be noticed."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from kinematics.model.robot_description import RobotDescription
from robots.control.health.finding import Ailment
from robots.simulated.faults.body_faults import BodyFaults

WEAK_SHARE = 0.1
OFFSET_RAD = (math.radians(2.0), math.radians(4.0))
BIAS_RAD_S = (math.radians(1.0), math.radians(3.0))
BATTERY = 0.1
# Arms do most of the moving; head and trunk have few joints.
_GROUPS = (("left_arm", 0.3), ("right_arm", 0.3), ("left_leg", 0.13), ("right_leg", 0.13), ("torso", 0.07))

Act = Callable[[BodyFaults, str, np.random.Generator], None]


@dataclass(frozen=True, slots=True)
class BodyFault:
    """One kind of fault.

    Attributes:
        act: Brings it about.
        noticed_as: What it may be found to be; a motor that gives nothing may first look weak, or its
            joint stuck.
        of_a_joint: Whether it strikes one joint.
        of_a_motor: Whether it shows only where the motor is asked for more than it gives.
    """

    act: Act
    noticed_as: tuple[Ailment, ...]
    of_a_joint: bool = True
    of_a_motor: bool = False


def _offset(faults: BodyFaults, joint: str, rng: np.random.Generator) -> None:
    sign = 1.0 if rng.random() < 0.5 else -1.0
    faults.offset_encoder(joint, sign * float(rng.uniform(*OFFSET_RAD)))


def _bias(faults: BodyFaults, _joint: str, rng: np.random.Generator) -> None:
    axis = rng.standard_normal(3)
    axis *= float(rng.uniform(*BIAS_RAD_S)) / float(np.linalg.norm(axis))
    faults.bias_gyro((float(axis[0]), float(axis[1]), float(axis[2])))


_NO_EFFORT = (Ailment.OFFLINE, Ailment.WEAK, Ailment.STUCK)

BODY_FAULTS: Mapping[str, BodyFault] = {
    "joint_stuck": BodyFault(lambda faults, joint, _: faults.jam(joint), (Ailment.STUCK,)),
    "joint_offline": BodyFault(lambda faults, joint, _: faults.cut_power(joint), _NO_EFFORT, of_a_motor=True),
    "joint_weak": BodyFault(
        lambda faults, joint, _: faults.weaken(joint, WEAK_SHARE), _NO_EFFORT, of_a_motor=True
    ),
    "encoder_offset": BodyFault(_offset, (Ailment.ENCODER_OFFSET,)),
    "gyro_bias": BodyFault(_bias, (Ailment.GYRO_BIAS,), of_a_joint=False),
    "battery_low": BodyFault(
        lambda faults, _joint, _: faults.set_battery(BATTERY), (Ailment.BATTERY_LOW,), of_a_joint=False
    ),
}


def struck_joint(description: RobotDescription, rng: np.random.Generator) -> str:
    """Draw the joint that a fault strikes."""
    draw = float(rng.random())
    group = "head"
    for name, share in _GROUPS:
        if draw < share:
            group = name
            break
        draw -= share
    # one without a neck, or without legs too
    instead = ("torso", *(f"{hand}_arm" for hand in description.arms))
    joints = next(filter(None, (description.groups.get(name, ()) for name in (group, *instead))))
    return joints[int(rng.integers(len(joints)))]
