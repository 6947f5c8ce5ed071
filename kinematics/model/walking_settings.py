"""How one robot walks, as data."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

UPRIGHT_RAD = 0.05
"""A pelvis that leans more than this does not start to walk: go home first."""


@dataclass(frozen=True, slots=True)
class TuckedArms:
    """Arms drawn in before the chest, where a robot walks that has no room for its hands at home.

    Attributes:
        joints: Positions of the joints of both arms, rad; those of one arm do not need those of the other.
        from_m: Height of their lowest point over the floor, m.
        front_m, half_width_m: How far they stand out ahead of the base and to each side, m.
        radius_m: Radius of the circle about the middle between the feet that they stay in when the robot
            turns on the spot, m.
    """

    joints: Mapping[str, float]
    from_m: float
    front_m: float
    half_width_m: float
    radius_m: float


@dataclass(frozen=True, slots=True)
class WalkingSettings:
    """Timing, reach and balance of a walk; lengths in m, times in s, angles in rad.

    Attributes:
        first_shift_s: Time from standing to the first lift of a foot.
        single_support_s, double_support_s: Of each step.
        closing_s: Time from the last landing until the DCM is between the feet.
        settle_s: Time from then until the robot is at rest.
        lift_m: Height of the swing foot's arc.
        spacing_m: Distance across between the feet's centres while walking.
        forward_m, backward_m, sideways_m, turn_rad: Most that the body advances in one step.
        narrowest_m, widest_m: Least and greatest distance across between the feet's centres.
        stride_forward_m, stride_backward_m, stride_widest_m: How far from the foot that stands the other one
            may land to catch the body after a push.
        stride_reach_m: How far along the floor a sole may be from below the CoM, at the height at which the
            robot walks.
        front_m, back_m, half_width_m: Room that the robot takes ahead of its base, behind it, and to
            each side.
        hands_from_m, hands_half_width_m: Height over the floor from which up the hands are, and the room that
            the robot takes to each side there.
        legs_radius_m, hands_radius_m: Radii of the circles about the middle between the feet that a robot
            stays in when it turns on the spot: below that height, and from there up.
        hand_radius_m: Radius of a ball about the TCP that contains a hand closed on something.
        sway_m: How much farther out, and lower, any part gets while the robot walks than while it stands.
        acceleration_m_s2, turn_acceleration_rad_s2: Of the body's velocity from step to step.
        dcm_gain: Feedback gain less 1: the ZMP is moved by ``1 + dcm_gain`` times the error of the DCM.
        zmp_inset_m: The ZMP stays this far inside the sole's edge.
        tucked: How it draws its arms in; None for one that cannot.
    """

    first_shift_s: float
    single_support_s: float
    double_support_s: float
    closing_s: float
    settle_s: float
    lift_m: float
    spacing_m: float
    forward_m: float
    backward_m: float
    sideways_m: float
    turn_rad: float
    narrowest_m: float
    widest_m: float
    stride_forward_m: float
    stride_backward_m: float
    stride_widest_m: float
    stride_reach_m: float
    front_m: float
    back_m: float
    half_width_m: float
    hands_from_m: float
    hands_half_width_m: float
    legs_radius_m: float
    hands_radius_m: float
    hand_radius_m: float
    sway_m: float
    acceleration_m_s2: float
    turn_acceleration_rad_s2: float
    dcm_gain: float
    zmp_inset_m: float
    tucked: TuckedArms | None = None

    @property
    def step_s(self) -> float:
        """Time from one landing to the next."""
        return self.single_support_s + self.double_support_s
