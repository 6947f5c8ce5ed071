"""What of a closed hand comes to a button first.

Fingertips that meet come along the fingers. Fingers that close on a palm are judged open: the fist is a
finger's length behind them, and they open onto what it has pressed. Such a hand is turned until its palm,
which no motor moves, comes first, with the fist behind it; where that is so follows from the links' shapes.
"""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass

import numpy as np
import pinocchio as pin

from kinematics.arrays import Array, Sealed
from kinematics.geometry import poses
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel
from kinematics.planning.pushing import corners_of, hand_points

_FOREMOST_M = 0.003
"""What is no farther behind what comes first comes with it."""
_TIPS_ROLLS_RAD = (0.0, math.pi)
_PALM_TURNS_RAD = tuple(math.radians(turn) for turn in (60.0, 45.0))
"""From pointing at the button; turned farther, a wrist comes near to what is behind it."""
_PALM_DOWN_RAD = tuple(math.radians(down) for down in (30.0, 0.0, 90.0))
"""So far below the horizontal the fingers of a hand that is turned point then."""
_CLEAR_M = 0.005
"""So far behind the palm a fist has to be: hands come turned by some degrees."""


@dataclass(frozen=True, slots=True)
class PressingFace(Sealed):
    """What of a closed hand comes first, one way in which it may come.

    Attributes:
        label: In words; empty for fingertips.
        tcp_R_face: Rotation, shape (3, 3), whose x is the way in which the hand comes.
        point_m: What comes first, in the TCP frame, shape (3,).
        open_ahead_m: So much farther that way open fingers would reach.
        rolls_rad: The hand may be turned so about that way, from the opening upright, the best first.
    """

    label: str
    tcp_R_face: Array
    point_m: Array
    open_ahead_m: float
    rolls_rad: tuple[float, ...]


def pressing_faces(model: RobotModel, hand: Hand, q: Array) -> tuple[PressingFace, ...]:
    """The ways in which a closed hand can press; none where fingers always come before the palm.

    Args:
        model: The robot.
        hand: Which hand.
        q: A configuration, in which fingertips are looked at.
    """
    if model.description.grippers[hand].motors:
        return model.derived(_palm_faces, hand)
    return (PressingFace("", np.eye(3), _tip(hand_points(model, hand, q)), 0.0, _TIPS_ROLLS_RAD),)


def _palm_faces(model: RobotModel, hand: Hand) -> tuple[PressingFace, ...]:
    gripper, links = model.description.grippers[hand], _closed_points(model, hand)
    palm = links.pop(gripper.base_link, None)
    if palm is None or not links:  # what has no shape meets nothing
        return ()
    opened, fist = hand_points(model, hand, model.q_home), np.concatenate(list(links.values()))
    found = []
    for turn, side in itertools.product(_PALM_TURNS_RAD, (1.0, -1.0)):
        rotation = poses.rotation_z(side * turn)
        (palm_m, fist_m, open_m) = (float((points @ rotation[:, 0]).max()) for points in (palm, fist, opened))
        if palm_m - fist_m < _CLEAR_M:
            continue
        label = f"palm {math.degrees(side * turn):+.0f} "
        point = rotation @ _tip(palm @ rotation)
        rolls = tuple(-0.5 * math.pi + side * down for down in _PALM_DOWN_RAD)
        found.append(PressingFace(label, rotation, point, max(0.0, open_m - palm_m), rolls))
    return tuple(found)


def _tip(points: Array) -> Array:
    """The middle of those that are foremost along x, as far ahead as the first of them, shape (3,)."""
    ahead = float(points[:, 0].max())
    tip = points[points[:, 0] > ahead - _FOREMOST_M].mean(axis=0)
    tip[0] = ahead
    return np.asarray(tip)


def _closed_points(model: RobotModel, hand: Hand) -> dict[str, Array]:
    """Corners of the collision shapes of each link of a closed hand, in its TCP frame, shape (n, 3) each."""
    gripper = model.description.grippers[hand]
    moving = pin.buildModelFromXML(model.description.urdf, pin.JointModelFreeFlyer())
    data, q = moving.createData(), pin.neutral(moving)
    for joint, at in zip(gripper.joints, gripper.joints_at(gripper.closed_rad), strict=True):
        q[moving.joints[moving.getJointId(joint)].idx_q] = at
    pin.framesForwardKinematics(moving, data, q)
    tcp = data.oMf[moving.getFrameId(gripper.tcp_frame)]
    found: dict[str, Array] = {}
    for item in model.geometry().geometryObjects:
        link = model.link_of(item)
        if link in gripper.links:
            link_T_item = model.pin.frames[item.parentFrame].placement.actInv(item.placement)
            tcp_T_item = tcp.actInv(data.oMf[moving.getFrameId(link)]).act(link_T_item)
            points = corners_of(item.geometry) @ tcp_T_item.rotation.T + tcp_T_item.translation
            found[link] = np.concatenate([found[link], points]) if link in found else points
    return found
