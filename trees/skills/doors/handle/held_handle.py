"""What is known of a handle or a front at which a hand is."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array, Sealed
from kinematics.requests.grasp import Grasp
from kinematics.scene.concessions import Concession, ConcessionReason, touching, with_touching
from kinematics.scene.opening_path import OpeningPath
from kinematics.scene.planning_scene import PlanningScene
from trees.beliefs.openings.drawer_inside import without_drawn
from trees.beliefs.openings.handles import HandleTarget, beside_bar
from trees.toolbox import Toolbox


@dataclass(frozen=True, slots=True)
class HeldHandle(Sealed):
    """A handle that a hand holds, or a front that it pushes, with the path that the hand has to follow.

    Attributes:
        target: The door or drawer.
        grasp: How the hand holds the handle.
        path: The path of the TCP that holds the handle.
        bias: What the hand's force estimate read before anything was touched, shape (6,); None when it is to
            be measured as the hand sets out.
    """

    target: HandleTarget
    grasp: Grasp
    path: OpeningPath
    bias: Array | None


def scene_of_hand(toolbox: Toolbox, target: HandleTarget, grasp: Grasp) -> PlanningScene:
    """The present scene, in which the hand may touch the handle and what it opens."""
    scene = without_drawn(toolbox.world.scene, target.part)
    return with_touching(scene, hand_concessions(toolbox, target, grasp, "lead"))


def hand_concessions(
    toolbox: Toolbox, target: HandleTarget, grasp: Grasp, step: str
) -> tuple[Concession, ...]:
    """What the hand may touch at a handle, asked of whoever judges the step."""
    gripper = toolbox.model.description.grippers[grasp.hand]
    scene = without_drawn(toolbox.world.scene, target.part)
    fits = not target.pushed and gripper.palm_side_m is None
    near = beside_bar(target, scene) if fits else ()
    parts = [name for name in (target.part, target.handle) if name in scene.objects]
    held = ConcessionReason.HANDLE_IN_HAND
    return (
        *touching(gripper.touch_links, parts, held, step),
        *touching(gripper.finger_links, near, held, step),
    )


def outwards(scene: PlanningScene, target: HandleTarget) -> NDArray[np.float64]:
    """Horizontal unit vector square to the front, to the side of its handle, shape (3,)."""
    if target.part not in scene.objects:
        return target.path.at(target.opening).outward
    pose = scene.objects[target.part].world_T_object
    normal = pose[:3, 0] * np.array([1.0, 1.0, 0.0])
    normal /= np.linalg.norm(normal)
    if target.pushed:
        return np.asarray(normal if normal @ target.path.at(target.opening).outward > 0.0 else -normal)
    bar_m = scene.objects[target.handle].world_T_object[:3, 3]
    return np.asarray(normal if (bar_m - pose[:3, 3]) @ normal > 0.0 else -normal)


def tcp_m(toolbox: Toolbox, grasp: Grasp, q: Array) -> Array:
    """Where the hand's TCP is at a configuration, shape (3,)."""
    frame = toolbox.model.description.grippers[grasp.hand].tcp_frame
    return toolbox.model.frame_pose(q, frame)[:3, 3]


def bar_m(toolbox: Toolbox, grasp: Grasp, q: Array) -> Array:
    """Where the middle of the bar is that a hand holds at a configuration, shape (3,): beside a palm."""
    gripper = toolbox.model.description.grippers[grasp.hand]
    tcp = toolbox.model.frame_pose(q, gripper.tcp_frame)
    return np.asarray(tcp[:3, 3] + gripper.held_at_m(grasp.diameter_m) * tcp[:3, 1])
