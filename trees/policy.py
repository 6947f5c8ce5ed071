"""Numbers that behaviors go by; each with its reason."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class TreePolicy:
    """Tolerances, counts and times of the behaviors.

    Attributes:
        look_frames: Frames that a look gathers; averages the frame noise down.
        look_timeout_s: A look that has not got its frames by then fails.
        moved_tolerance_m: A target seen farther than this from where it was planned for has moved.
        pick_attempts: Grasps that are tried before a pick gives up.
        hold_s: How long the object must stay held after the lift before it counts.
        lift_m: How far an object is lifted.
        lifted_min_m: Least rise of the object, as seen, that counts as lifted.
        furniture_margin_m: Kept from furniture; three times the usual perception bias.
        object_margin_m: Kept from objects that are not the target.
    """

    look_frames: int = 8
    look_timeout_s: float = 2.0
    moved_tolerance_m: float = 0.015
    pick_attempts: int = 4
    hold_s: float = 2.0
    lift_m: float = 0.13
    lifted_min_m: float = 0.10
    furniture_margin_m: float = 0.015
    object_margin_m: float = 0.010
