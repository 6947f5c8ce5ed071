"""Numbers that behaviors of several skills go by; each with its reason."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, TypeVar

S = TypeVar("S")


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
    """Tolerances, counts and times that several skills go by; those of one skill live in its folder.

    Attributes:
        skills: Settings of single skills that are other than usual, at most one of each type.
        look_frames: Frames that a look gathers; averages the frame noise down.
        look_timeout_s: A look that has not got its frames by then fails.
        lift_m: How far an object is lifted.
        furniture_margin_m: Kept from furniture; three times the usual perception bias.
        object_margin_m: Kept from every object, unless the plan lets the pair touch.
        search_gazes: The order in which a search looks: a table ahead, then, leaning over it, what is
            too near for the head alone (on a high table with less of a lean: nothing is seen nearer to the
            camera than 0.3 m), then what is far to the sides.
        last_gaze: The one that is left for what no other shows: eyes that lean over a high table are straight
            above what stands at its near edge; from farther behind they see it.
        first_lean_rad: Of the trunk, in the first look for what is to be picked up: what stands at the near
            edge of a low table is below the picture of who stands upright, and in the way of the hand.
        most_tilt_rad: What is level may seem to lean by so much: calibration leaves a fifth. Where it is
            more, the camera has been turned.
        sure_from: A thing that is seen less surely than this is looked at from elsewhere before anything is
            done with it; what stays unsure is asked about.
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
        lost_grip_s: The gripper may read "not holding" for this long before it counts; a few readings.
        in_hand_tolerance_m: A held object is seen this near to where the hand should have it; closing
            fingers move an object by up to the clearance of the open hand.
        stand_m, stand_rad: The robot stands this near to where it should, as it sees; the truth adds the
            perception's bias.
        level_gazes: The order in which people are looked for.
        place_attempts: Spots that are tried before a place gives up.
        retreat_m: How far an opened hand is drawn back.
        undisturbed_m: What stands about is seen again this near to where it stood; the perception's bias of
            one thing stays the same from look to look, and the mean of a look's noise is 1 mm.
        walk_timeout_s: Longest walk to something, looking for it and corrections included.
        task_timeout_s: A whole task takes less; what is left of a session's limit is for giving up tidily.
    """

    skills: tuple[Any, ...] = ()
    look_frames: int = 8
    look_timeout_s: float = 2.0
    lift_m: float = 0.13
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
    most_tilt_rad: float = 0.015
    sure_from: float = 0.5
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
    lost_grip_s: float = 0.05
    in_hand_tolerance_m: float = 0.04
    stand_m: float = 0.008
    stand_rad: float = 0.02
    level_gazes: tuple[Gaze, ...] = (
        Gaze("level", tilt_rad=0.15),
        Gaze("level left", tilt_rad=0.15, pan_rad=0.85),
        Gaze("level right", tilt_rad=0.15, pan_rad=-0.85),
    )
    place_attempts: int = 3
    retreat_m: float = 0.10
    undisturbed_m: float = 0.010
    walk_timeout_s: float = 300.0
    task_timeout_s: float = 120.0

    def of(self, kind: type[S]) -> S:
        """The settings of one skill: those that were given, or the usual ones.

        Args:
            kind: Their type, of the skill's folder; made without arguments it is as usual.
        """
        return next((one for one in self.skills if type(one) is kind), None) or kind()
