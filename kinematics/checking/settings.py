"""What the trajectory checker tolerates, and how finely it looks."""

from __future__ import annotations

from dataclasses import dataclass

SPARE_M = 2e-5
"""What two solids of a checked motion have to spare beyond the distance that they must keep."""


@dataclass(frozen=True, slots=True)
class CheckSettings:
    """Tolerances of the trajectory checker; the limits themselves are the robot's data.

    Attributes:
        position_rad: A joint may pass its position limit by this much (numerical noise only).
        velocity_fraction: A joint's speed may pass its limit by this fraction (the same).
        acceleration_fraction: The same for the acceleration. Cubic pieces through exact samples of a
            motion that rides on both its acceleration and its jerk limit overshoot the former by up
            to 8/27 of jerk times spacing; who times motions has to leave that room.
        jerk_fraction: The same for the jerk.
        jerk_window_s: A sudden change of acceleration at a sample is spread over the spacing of the
            samples, but over no more than this, to be judged as jerk.
        discontinuity_factor: Two neighbouring samples that could only be joined with this many times
            the acceleration limit are a jump, not a motion.
        stance_m, stance_rad: A sole may stray this far from where the stance says it stands.
        base_jump_m, base_jump_rad: Two neighbouring base poses may depart this far from what the base
            velocities of both samples say.
        collision_m: Two solids nearer than this (beyond the margin to keep and ``spare_m``) count as
            touching. It also ends the refinement: nearer pairs are findings, farther ones are certified.
        spare_m: Two solids are certified to keep so much more than the margin: what they may approach
            each other by while a motion is led in, which nobody checks (see ``start_gap``).
        cell_s: Length of the time intervals that the collision check with Coal starts from.
        cut_rad: The compiled collision check begins by cutting a motion into parts in which no joint goes
            farther than about this: hardly anything near can be proven of longer ones.
        subdivision: Into how many an interval is split that could not be certified.
        dynamics_period_s: Spacing of the configurations at which CoM, ZMP and efforts are computed.
            Joints within their acceleration limit bend a path by less than 0.4 mrad in that time.
        acceleration_window_s: Accelerations for ZMP and efforts are differences of velocities over
            this time to both sides.
        com_tolerance_m: The CoM margin may be undercut by this much (numerical noise only).
        zmp_margin_m: The ZMP stays this far inside the support polygon. At zero the feet begin to tip.
    """

    position_rad: float = 1e-6
    velocity_fraction: float = 1e-6
    acceleration_fraction: float = 1e-6
    jerk_fraction: float = 1e-6
    jerk_window_s: float = 0.02
    discontinuity_factor: float = 4.0
    stance_m: float = 1e-3
    stance_rad: float = 2e-3
    base_jump_m: float = 1e-3
    base_jump_rad: float = 2e-3
    collision_m: float = 2e-5
    spare_m: float = SPARE_M
    cell_s: float = 0.04
    cut_rad: float = 0.1
    subdivision: int = 4
    dynamics_period_s: float = 0.02
    acceleration_window_s: float = 0.01
    com_tolerance_m: float = 1e-4
    zmp_margin_m: float = 0.0


DEFAULT_SETTINGS = CheckSettings()
