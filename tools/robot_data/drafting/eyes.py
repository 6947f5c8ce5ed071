"""The camera that a robot goes by: a frame of its URDF, or a stand beside an arm that has none."""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np
import pinocchio as pin

from kinematics.arrays import Array
from kinematics.geometry import poses
from tools.robot_data.drafting.anatomy import Anatomy
from tools.robot_data.drafting.limbs import Limbs

_NAMES = (r"rgb.*optical", r"color.*optical", r"optical", r"rgb|camera|cam_|realsense|d435", r"eye")
"""Links that see, the surest first."""
_LOOKS_AHEAD = 0.3
"""The least share of a camera's axis that points ahead."""
_ALONG = 0.9
DRAFTED = "drafted_eyes"
"""The frame that is added where the URDF has none whose axes are those of a picture."""
OPTICAL = np.column_stack([[0.0, -1.0, 0.0], [0.0, 0.0, -1.0], [1.0, 0.0, 0.0]])
"""Axes of a picture that is taken ahead: x right, y down, z ahead."""


@dataclass(frozen=True, slots=True)
class Eyes:
    """A camera.

    Attributes:
        frame: Its optical frame.
        link, link_T_frame: Where the frame is to be added; None when the URDF has it.
        pan, tilt: Joints that aim it; None where none do.
        why: What it was made from.
    """

    frame: str
    link: str | None
    link_T_frame: Array | None
    pan: str | None
    tilt: str | None
    why: str


def eyes_of(anatomy: Anatomy, limbs: Limbs, base_link: str, reach_m: float) -> Eyes | None:
    """The camera of a robot; None for one that stands and has none."""
    link = _seeing_link(anatomy, limbs)
    if link is None:
        return None if limbs.standing else _stand(base_link, reach_m)
    carriers = anatomy.way(_carrier(anatomy, link)) if _carrier(anatomy, link) else []
    neck = [name for name in limbs.groups.get("head", ()) if name in carriers]
    pan = next((name for name in neck if anatomy.axis(name)[2] > _ALONG), None)
    tilt = next((name for name in neck if anatomy.axis(name)[1] > _ALONG), None)
    if pan is None or tilt is None:
        pan = tilt = None
    frame = anatomy.frame(link)
    if "optical" in link.lower() and frame[0, 2] > _LOOKS_AHEAD:
        return Eyes(link, None, None, pan, tilt, "a link of the URDF by its name")
    wanted = poses.transform(OPTICAL, frame[:3, 3])
    return Eyes(
        DRAFTED, link, poses.inverse(frame) @ wanted, pan, tilt, "where that link is, looking straight ahead"
    )


def _seeing_link(anatomy: Anatomy, limbs: Limbs) -> str | None:
    """The link that is most surely a camera's, on no arm: those of wrists see what the hand is at."""
    arms = {name for group, joints in limbs.groups.items() if group.endswith("_arm") for name in joints}
    names = [
        str(frame.name)
        for frame in anatomy.model.frames
        if frame.type == pin.FrameType.BODY
        and not arms
        & set(anatomy.way(str(anatomy.model.names[frame.parentJoint])) if frame.parentJoint else ())
    ]
    for pattern in _NAMES:
        for name in names:
            if re.search(pattern, name, re.I):
                return name
    return None


def _carrier(anatomy: Anatomy, link: str) -> str:
    """The joint that moves a link; empty at the base."""
    number = anatomy.model.frames[anatomy.frame_id(link)].parentJoint
    return str(anatomy.model.names[number]) if number else ""


def _stand(base_link: str, reach_m: float) -> Eyes:
    """A camera on a stand of its own, before the arm, that looks back and down."""
    down = poses.rotation_y(0.78)  # of a camera that looks along -x
    turn = poses.rotation_z(np.pi) @ down @ OPTICAL
    place = poses.transform(turn, [1.3 * reach_m, 0.0, 0.8 * reach_m])
    return Eyes(
        DRAFTED, base_link, place, None, None, "the URDF has no camera: one on a stand before the arm"
    )
