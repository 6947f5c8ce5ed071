"""Numbers that behaviors go by; each with its reason."""

from __future__ import annotations

import math
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Gaze:
    """A direction to look in.

    Attributes:
        name: What it is called in the tree.
        tilt_rad: Of the head, down.
        pan_rad: Of the head, to the left.
        lean_rad: Of the trunk, forward; left out by a robot that cannot lean.
        turn_rad: Of the trunk, to the left; left out by a robot that cannot turn it.
        back_m: The pelvis goes so far behind where it is at home; left out by a robot on a mount. With 0 it
            stays where it is.
    """

    name: str
    tilt_rad: float
    pan_rad: float = 0.0
    lean_rad: float = 0.0
    turn_rad: float = 0.0
    back_m: float = 0.0


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
        object_margin_m: Kept from every object, unless the plan lets the pair touch.
        search_gazes: The order in which a search looks: a table ahead, then, leaning over it, what is
            too near for the head alone (on a high table with less of a lean: nothing is seen nearer to the
            camera than 0.3 m), then what is far to the sides.
        last_gaze: The one that is left for what no other shows: eyes that lean over a high table are straight
            above what stands at its near edge; from farther behind they see it.
        first_lean_rad: Of the trunk, in the first look for what is to be picked up: what stands at the near
            edge of a low table is below the picture of who stands upright, and in the way of the hand.
        looks_for_twins: Whether a part of a table that is out of view is looked at before the only thing in
            view that fits is taken for the one that is meant.
        survey_gazes: Where else the head looks before it is said which of several things is meant: what the
            first gaze cuts off on both sides of a table, without leaning.
        beside_rad: What is farther to a side than this is beside or behind the robot: no turn of the head
            shows it.
        gaze_tolerance_rad: An aim nearer than this is left as it is; a twentieth of the view.
        same_object_m: Two looks that see a kind and colour nearer than this saw the same object; half
            the distance at which two cups can still be grasped apart.
        slid_m: What looks like the thing in a hand and hangs in the air this near to it is that one: pushed
            it slides by centimetres, and an encoder that slipped shows it as far off.
        same_furniture_m: The same for furniture, whose pieces are larger and farther apart.
        hidden_by_hand_m: Something whose line of sight passes a hand nearer than this may be hidden by it.
        blocked_by_hand_m: A line of sight that keeps this far from hands and forearms is free for certain.
        support_gap_m: Between an object's lowest point and the furniture it stands on, at most: both
            carry a perception bias.
        motion_slack_s: A motion may take this much longer than planned, settling included.
        arrival_tolerance_rad: Every joint is this near the end of its trajectory; three times the lag
            of a loaded wrist.
        grasp_settle_s: Between the end of the closing and the reading that counts.
        opening_tolerance_m: Difference of the gripper's opening from the object's diameter that size
            estimate and finger geometry explain; more means that something else is held.
        lost_grip_s: The gripper may read "not holding" for this long before it counts; a few readings.
        slip_max_m: An object that moves more than this in the hand, as seen between the two halves of
            the hold, is slipping; four times the error of a half's mean.
        in_hand_tolerance_m: A held object is seen this near to where the hand should have it; closing
            fingers move an object by up to the clearance of the open hand.
        unseen_hold_factor: A hold that cannot be seen must last this much longer.
        fastest_m_s, fastest_rad_s: Speed limits of a walk; the robot's own may be lower.
        stand_m, stand_rad: The robot stands this near to where it should, as it sees; the truth adds the
            perception's bias.
        walk_attempts: How often it walks, corrections included.
        move_s: How long a move takes that is asked for without an end.
        level_gazes: The order in which people are looked for.
        looks_past: How often, after all gazes, the eyes are taken elsewhere, past what hides something.
        inventory_gazes: The looks that together see everything within reach of the arms, the near corners of
            a table beside the robot at last.
        wave_swings: How often a waving hand goes from side to side.
        wave_width_m: From one side to the other.
        wave_least_m: A swing narrower than this, as measured, does not count.
        wave_least_swings: Fewer than so many is no waving.
        pointing_tolerance_m: The line through forearm and hand passes its target nearer than this.
        pointing_hold_s: How long the arm stays stretched out.
        centred: What is looked at is this near to the picture's centre, as a share of half the picture.
        place_attempts: Spots that are tried before a place gives up.
        touch_n: Lift of the hand that says that what it holds stands on something.
        rest_s: The hand is felt at rest for so long before it is lowered.
        early_touch_m: A touch so far above where it should come is one with something else.
        further_m: How much farther down each further step goes when nothing was touched.
        retreat_m: How far an opened hand is drawn back.
        undisturbed_m: What stands about is seen again this near to where it stood; the perception's bias of
            one thing stays the same from look to look, and the mean of a look's noise is 1 mm.
        shifted_m: What is seen so far from where the hand should have it has shifted in the hand; a bias
            of 5 mm that turns with the hand looks like 7 mm.
        placed_tolerance_m: A placed object is seen this near to where it was meant to stand.
        shelved_tolerance_m: The same on a board behind a door, where being in there was asked for and not a
            spot: as much as such a spot keeps from the board's edges.
        offer_rest_s: An offering hand is felt at rest for so long first.
        pull_n: A change of the force on an offering hand that is a pull; a touch of 2 N is none.
        pull_s: It has to last so long.
        take_within_s: Nobody has taken it by then: it is taken back.
        after_giving_s: Between letting go and looking where it went.
        walk_timeout_s: Longest walk to something, looking for it and corrections included.
        confidence_slope, confidence_offset: From how surely things were seen to how often answers about
            them are right, a line in the log-odds; fitted by ``tools.calibration``.
        task_timeout_s: A whole task takes less; what is left of a session's limit is for giving up tidily.
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
    search_gazes: tuple[Gaze, ...] = (
        Gaze("ahead", tilt_rad=0.75),
        Gaze("near", tilt_rad=0.77, lean_rad=0.45),
        Gaze("near and high", tilt_rad=0.77, lean_rad=0.36),
        Gaze("near left", tilt_rad=0.77, pan_rad=0.7, lean_rad=0.45),
        Gaze("near right", tilt_rad=0.77, pan_rad=-0.7, lean_rad=0.45),
        Gaze("at the body", tilt_rad=0.77, lean_rad=0.6),
        Gaze("far left", tilt_rad=0.5, pan_rad=0.7),
        Gaze("far right", tilt_rad=0.5, pan_rad=-0.7),
    )
    last_gaze: Gaze = Gaze("before the body", tilt_rad=0.77, lean_rad=0.45, back_m=0.09)
    first_lean_rad: float = 0.2
    looks_for_twins: bool = True
    survey_gazes: tuple[Gaze, ...] = (
        Gaze("to the left", tilt_rad=0.75, pan_rad=0.5),
        Gaze("to the right", tilt_rad=0.75, pan_rad=-0.5),
    )
    beside_rad: float = math.radians(60.0)
    gaze_tolerance_rad: float = 0.05
    same_object_m: float = 0.05
    slid_m: float = 0.15
    same_furniture_m: float = 0.20
    hidden_by_hand_m: float = 0.15
    blocked_by_hand_m: float = 0.10
    support_gap_m: float = 0.05
    motion_slack_s: float = 1.0
    arrival_tolerance_rad: float = 0.05
    grasp_settle_s: float = 0.2
    opening_tolerance_m: float = 0.012
    lost_grip_s: float = 0.05
    slip_max_m: float = 0.008
    in_hand_tolerance_m: float = 0.04
    unseen_hold_factor: float = 2.0
    fastest_m_s: float = 0.5
    fastest_rad_s: float = 1.0
    stand_m: float = 0.008
    stand_rad: float = 0.02
    walk_attempts: int = 4
    move_s: float = 3.0
    level_gazes: tuple[Gaze, ...] = (
        Gaze("level", tilt_rad=0.15),
        Gaze("level left", tilt_rad=0.15, pan_rad=0.85),
        Gaze("level right", tilt_rad=0.15, pan_rad=-0.85),
    )
    inventory_gazes: tuple[Gaze, ...] = (
        Gaze("ahead", tilt_rad=0.75),
        Gaze("left", tilt_rad=0.7, pan_rad=0.6),
        Gaze("right", tilt_rad=0.7, pan_rad=-0.6),
        Gaze("near", tilt_rad=0.77, lean_rad=0.5),
        Gaze("near left", tilt_rad=0.7, pan_rad=-0.4, lean_rad=0.5, turn_rad=0.7),
        Gaze("near right", tilt_rad=0.7, pan_rad=0.4, lean_rad=0.5, turn_rad=-0.7),
        Gaze("beside left", tilt_rad=0.77, pan_rad=0.2, lean_rad=0.35, turn_rad=0.4),
        Gaze("beside right", tilt_rad=0.77, pan_rad=-0.2, lean_rad=0.35, turn_rad=-0.4),
    )
    looks_past: int = 6
    wave_swings: int = 4
    wave_width_m: float = 0.26
    wave_least_m: float = 0.15
    wave_least_swings: int = 3
    pointing_tolerance_m: float = 0.10
    pointing_hold_s: float = 1.5
    centred: float = 0.10
    place_attempts: int = 3
    touch_n: float = 6.0
    rest_s: float = 0.3
    early_touch_m: float = 0.025
    further_m: float = 0.008
    retreat_m: float = 0.10
    undisturbed_m: float = 0.010
    shifted_m: float = 0.008
    placed_tolerance_m: float = 0.02
    shelved_tolerance_m: float = 0.03
    offer_rest_s: float = 0.5
    pull_n: float = 3.0
    pull_s: float = 0.15
    take_within_s: float = 15.0
    after_giving_s: float = 0.8
    walk_timeout_s: float = 300.0
    confidence_slope: float = 0.85
    confidence_offset: float = 1.7
    task_timeout_s: float = 120.0
