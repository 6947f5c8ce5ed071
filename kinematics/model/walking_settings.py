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
        from_m: From this height up the arms are.
        front_m, half_width_m: Room that they take ahead of the base and to each side, m.
        radius_m: Of the circle about the middle between the feet in which they turn.
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
        first_shift_s: From standing to the first lift.
        single_support_s, double_support_s: Of each step.
        closing_s: From the last landing until the DCM is between the feet.
        settle_s: From there to rest.
        lift_m: Height of the swing foot's arc.
        spacing_m: Between the feet's centres while walking.
        forward_m, backward_m, sideways_m, turn_rad: Most that the body advances in one step.
        narrowest_m, widest_m: Between the feet's centres, across.
        stride_forward_m, stride_backward_m, stride_widest_m: From the foot that stands to a landing that
            catches the body after a push.
        stride_reach_m: Of a sole from the CoM, over the floor, at the height that the robot walks with.
        front_m, back_m, half_width_m: Room that the robot takes ahead of its base, behind it, and to
            each side.
        hands_from_m, hands_half_width_m: From this height up, where the hands are, it takes so much room to
            each side.
        legs_radius_m, hands_radius_m: Of the circles about the middle between the feet that a robot which
            turns on the spot goes around in, below that height and from there up.
        hand_radius_m: Of a ball about the TCP that holds a hand which is closed on something.
        sway_m: So much farther, and lower, than it stands still anything gets while the robot walks.
        acceleration_m_s2, turn_acceleration_rad_s2: Of the body's velocity from step to step.
        dcm_gain: Share of the DCM's error that is added to the ZMP, less 1.
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
