"""Numbers of picking up; each with its reason."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class PickSettings:
    """Numbers of picking up.

    Attributes:
        moved_tolerance_m: A target seen farther than this from where it was planned for has moved.
        pick_attempts: Grasps that are tried before a pick gives up.
        hold_s: How long the object must stay held after the lift before it counts.
        lifted_min_m: Least rise of the object, as seen, that counts as lifted.
        grasp_settle_s: Between the end of the closing and the reading that counts.
        opening_tolerance_m: Difference of the gripper's opening from the object's diameter that size
            estimate and finger geometry explain; more means that something else is held.
        slip_max_m: An object that moves more than this in the hand, as seen between the two halves of
            the hold, is slipping; four times the error of a half's mean.
        unseen_hold_factor: A hold that cannot be seen must last this much longer.
    """

    moved_tolerance_m: float = 0.015
    pick_attempts: int = 4
    hold_s: float = 2.0
    lifted_min_m: float = 0.10
    grasp_settle_s: float = 0.2
    opening_tolerance_m: float = 0.012
    slip_max_m: float = 0.008
    unseen_hold_factor: float = 2.0
