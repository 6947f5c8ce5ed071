"""What a document may loosen of what the checker judges, by how much and why; everything else is refused.

A document comes from outside: a file, or the other side of a socket. It may say what the motion's own work
brings with it, and no more: how the robot may touch itself, the floor, its limits, its soles and its
tolerances are those of the robot's description, and have no word in any document.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import coal
import numpy as np
import pinocchio as pin

from kinematics.arrays import Array
from kinematics.distance.link_solids import coal_solids
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Ball, Box, Shape
from kinematics.model.robot_model import RobotModel
from kinematics.scene.planning_scene import FLOOR, Pair, PlanningScene

BEGINS_NEAR_M = 0.01
"""A link that a motion begins with beside a thing is so near to it, beyond the margin: what plans keep in
reserve, and what perception may be wrong by."""
SAME_SIZE_M = 0.02
"""What a hand holds of a scene may be so much smaller than the scene says: perception errs by less."""


@dataclass(frozen=True, slots=True)
class Loosened:
    """One rule of the checker that the document of a trajectory may loosen, and how far.

    Attributes:
        what: The key of the document, and what it says there.
        bound: How far it may; a document that goes beyond this is refused.
        why: What kind of motion needs it.
    """

    what: str
    bound: str
    why: str


LOOSENED: tuple[Loosened, ...] = (
    Loosened(
        "allowed: a link of a gripper and an object",
        "links of the robot's grippers; of what a hand holds, that hand's; never a person of a scene file",
        "a hand closes on a thing or a handle, and opens from it",
    ),
    Loosened(
        "allowed: what a hand holds and an object",
        "not the floor, not what the other hand holds, never a person of a scene file",
        "a thing is taken from what carries it, and put down on it",
    ),
    Loosened(
        "allowed: another link and an object",
        "the motion begins with them within the object's margin and 10 mm",
        "no motion could lead away from what the robot stands against, or is mounted on",
    ),
    Loosened(
        "held.touch_links",
        "links that the frame is fixed to, and those of its gripper",
        "what is in a hand touches the hand",
    ),
    Loosened(
        "held: an object of the scene leaves the world",
        "a hand holds it; no furniture, no person; not smaller than the scene says, to 20 mm",
        "what was picked up is no longer where it stood",
    ),
    Loosened(
        "objects: what is around, and margin_m",
        "margins of 0 or more, and at least what --margin says; a scene that is given beside the document "
        "takes their place",
        "the control side knows of no scene but the commander's; a recorded motion is judged in its own",
    ),
    Loosened(
        "stance: which soles carry, and where",
        "soles of the robot, at least one where it has any, on the floor to 5 mm and 0.02 rad",
        "a robot stands on one foot or on two, wherever it has walked",
    ),
    Loosened(
        "bias: of a yielding hand's force estimate",
        "10 N and 10 Nm",
        "what was measured before anything was touched counts as no force",
    ),
)
"""The whole list; ``docs/reference/trajectory.md`` tells it to users."""


def why_not_allowed(pair: Pair, scene: PlanningScene, model: RobotModel, q: Array | None) -> str | None:
    """Why a document may not say that two may touch; None when it may.

    Args:
        pair: Names that are the robot's, the scene's or the floor's.
        scene: With what the hands hold.
        model: The robot.
        q: Where the motion begins, shape (nq,); when left out, every link is taken to begin beside a thing.
    """
    first, second = sorted(pair)
    if FLOOR in pair:
        other = second if first == FLOOR else first
        return f"{other!r} may not touch the floor: only soles stand on it, as the robot's description says"
    mine = [name for name in (first, second) if model.pin.existFrame(name)]
    if len(mine) == 2:
        return (
            f"{first!r} and {second!r} are both parts of the robot: which of them may touch is its "
            "description's to say"
        )
    if not mine:
        if pair <= scene.attached.keys():
            return f"{first!r} and {second!r} are both held: no motion needs them to touch"
        return None
    link, other = mine[0], second if mine[0] == first else first
    held = scene.attached.get(other)
    touching = links_of_grippers(model) if held is None else links_about(model, held.frame)
    if link in touching or q is None:
        return None
    margin_m = 0.0 if held is not None else scene.objects[other].margin_m
    apart_m = _distance_m(model, q, link, *_placed(model, scene, q, other))
    if apart_m <= margin_m + BEGINS_NEAR_M:
        return None
    return (
        f"{link!r} and {other!r} may not touch: the link is of no hand that takes it, and the motion does "
        f"not begin with them side by side ({apart_m:.3g} m apart)"
    )


def links_of_grippers(model: RobotModel) -> frozenset[str]:
    """Every link of every gripper."""
    grippers = model.description.grippers.values()
    return frozenset(link for gripper in grippers for link in (*gripper.links, *gripper.touch_links))


def links_about(model: RobotModel, frame: str) -> frozenset[str]:
    """Links that a frame is fixed to, and those of the gripper whose TCP is fixed to the same."""
    joint = _joint_of(model, frame)
    fixed = {str(item.name) for item in model.pin.frames if item.parentJoint == joint}
    for gripper in model.description.grippers.values():
        if _joint_of(model, gripper.tcp_frame) == joint:
            fixed |= {*gripper.links, *gripper.touch_links}
    return frozenset(fixed)


def is_of_a_hand(model: RobotModel, frame: str) -> bool:
    """Whether a frame is fixed to what one of the robot's TCPs is fixed to."""
    tcps = {_joint_of(model, tcp) for tcp in model.description.tcp_frames.values()}
    return _joint_of(model, frame) in tcps


def is_smaller(shape: Shape, other: Shape) -> bool:
    """Whether a solid is clearly smaller than another one, however either is turned."""
    return bool(np.any(np.array(_sizes_m(shape)) < np.array(_sizes_m(other)) - SAME_SIZE_M))


def _sizes_m(shape: Shape) -> Sequence[float]:
    if isinstance(shape, Box):
        return sorted(shape.size_m)
    if isinstance(shape, Ball):
        return [2.0 * shape.radius_m] * 3
    return sorted((2.0 * shape.radius_m, 2.0 * shape.radius_m, shape.height_m))


def _joint_of(model: RobotModel, frame: str) -> int:
    return int(model.pin.frames[model.frame_id(frame)].parentJoint)


def _placed(model: RobotModel, scene: PlanningScene, q: Array, name: str) -> tuple[Shape, Transform]:
    """An object or a held thing, and where it is."""
    held = scene.attached.get(name)
    if held is None:
        return scene.objects[name].shape, scene.objects[name].world_T_object
    return held.body.shape, model.frame_pose(q, held.frame) @ held.frame_T_object


def _distance_m(model: RobotModel, q: Array, link: str, shape: Shape, world_T_shape: Transform) -> float:
    """From a link to a solid; infinite for a frame that has no solid."""
    geometry = model.geometry()
    placed = geometry.createData()
    pin.updateGeometryPlacements(model.pin, model.pin.createData(), geometry, placed, q)
    solids = coal_solids(shape)
    there = coal.Transform3s(world_T_shape[:3, :3], world_T_shape[:3, 3])
    apart_m = [
        coal.distance(
            item.geometry,
            coal.Transform3s(at.rotation, at.translation),
            solid,
            there,
            coal.DistanceRequest(),
            coal.DistanceResult(),
        )
        for item, at in zip(geometry.geometryObjects, placed.oMg, strict=True)
        if model.link_of(item) == link
        for solid in solids
    ]
    return float(min(apart_m, default=np.inf))
