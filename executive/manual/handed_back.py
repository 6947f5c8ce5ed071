"""What a person says is so when the robot is given back, and what the robot measures of it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from executive.manual.words import Ending
from kinematics.geometry import poses
from kinematics.geometry.shapes import Cylinder
from kinematics.model.robot_description import Hand
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from trees.beliefs.scene.held_object import fits
from trees.failures import Failure, Number
from trees.toolbox import Toolbox

PERSON = "person"
"""Who did it, in evidence and report."""
HELD_FOR_S = 1.5
"""The fingers have to feel it for so long."""
_HEIGHT_M = 0.1
"""Of a thing that nobody has seen, between the fingers: half of it above them."""
_NEAR_M = 0.12
"""A thing that was believed to be so near to the fingers is where it was believed to be."""
_MARGIN_M = 0.01


def hand_of(ending: Ending) -> Hand | None:
    """The hand that is said to hold the thing, or None."""
    match ending:
        case "held_left":
            return "left"
        case "held_right":
            return "right"
        case _:
            return None


class HoldCheck:
    """Measures for a while whether a hand holds what a person says that it holds.

    Args:
        toolbox: What is sensed.
        hand: The hand.
    """

    def __init__(self, toolbox: Toolbox, hand: Hand) -> None:
        self._toolbox, self._hand = toolbox, hand
        self._began_s = toolbox.clock.now_s()
        self._felt_s: float | None = self._began_s

    def tick(self) -> Mapping[str, Number] | Failure | None:
        """Go on by a tick: the evidence, why it is not so, or None while it is measured."""
        toolbox, hand = self._toolbox, self._hand
        now_s = toolbox.clock.now_s()
        if hand not in toolbox.grippers:
            return Failure.postcondition(f"there are no fingers at the {hand} hand")
        reading = toolbox.grippers[hand].reading()
        if reading.holding:
            self._felt_s = now_s
        elif self._felt_s is None or now_s - self._felt_s > toolbox.policy.lost_grip_s:
            return Failure.postcondition(
                f"the person says that it is in the {hand} hand, but its fingers hold nothing",
                cause=None,
                **reading.felt,
            )
        if now_s - self._began_s < HELD_FOR_S or not reading.holding:
            return None
        return {
            "hand": hand,
            "gripper_opening_m": reading.opening_m,
            **reading.effort,
            "held_s": now_s - self._began_s,
            "by": PERSON,
        }


def note_held(toolbox: Toolbox, command: Any, hand: Hand, opening_m: float) -> str:
    """Believe that a hand holds what a command is about; gives its name in the scene.

    Args:
        toolbox: Holds what is believed.
        command: The task.
        hand: The hand.
        opening_m: How far its fingers are apart.
    """
    world, model = toolbox.world, toolbox.model
    gripper, scene = model.description.grippers[hand], world.scene
    for name, held in scene.attached.items():
        if held.frame == gripper.tcp_frame:
            return name
    odom_T_tcp = model.frame_pose(toolbox.sensing.state().q, gripper.tcp_frame)
    wanted = getattr(command, "object", None)
    known = _nearest(scene, wanted, odom_T_tcp[:3, 3])
    if known is None:
        name = _free_name(scene, str(wanted) if wanted is not None else "thing")
        shape = Cylinder(max(0.5 * opening_m, 0.005), _HEIGHT_M)
        known = SceneObject(name, shape, odom_T_tcp, margin_m=_MARGIN_M)
        scene = scene.with_object(known)
    tcp_T_object = poses.inverse(odom_T_tcp) @ known.world_T_object
    if float(np.linalg.norm(tcp_T_object[:3, 3])) > _NEAR_M:
        tcp_T_object = np.eye(4)
    world.update(scene.with_attached(known.name, gripper.tcp_frame, tcp_T_object, gripper.touch_links))
    world.last_acted_on = known.name
    return known.name


def _nearest(scene: PlanningScene, wanted: Any, place_m: Any) -> SceneObject | None:
    """What is believed to be there and fits, the nearest to the fingers."""
    likely = [item for item in scene.objects.values() if item.movable and fits(item, wanted)]
    return min(
        likely, key=lambda item: float(np.linalg.norm(item.world_T_object[:3, 3] - place_m)), default=None
    )


def _free_name(scene: PlanningScene, words: str) -> str:
    taken, name, count = {*scene.objects, *scene.attached}, words, 2
    while name in taken:
        name, count = f"{words} {count}", count + 1
    return name
