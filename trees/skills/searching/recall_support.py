"""Recall what a thing stood on that was seen before, to look for it there first."""

from __future__ import annotations

import math
from collections.abc import Mapping

from py_trees.common import Status

from kinematics.scene.planning_scene import SceneObject
from kinematics.scene.support_of import support_of
from robots.perception.detector import Category
from trees.beliefs.grounding.destination import Place
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.ports import ports
from trees.readings.odometry import feet_pose
from trees.skills.searching.recall_place import RecallPlace
from trees.toolbox import Toolbox

_FAR_M = 1.3
"""A look to all sides shows what is nearer, and not farther round than this."""


class RecallSupport(RecallPlace):
    """Recall the furniture on which the only thing that fits was last seen, to look for it there first.

    If it stood on none, it is the place of the thing itself. The robot goes to the nearest side, from where
    it sees whether the thing still stands there; it need not be within reach. A place that is near and ahead
    is not recalled, for it was looked at already.
    """

    INPUT_PORTS = ports(task=object)
    OUTPUT_PORTS = ports(place=Place)
    CONTRACT = Contract(
        precondition="it was looked for from here, to all sides",
        postcondition="what the only thing that fits stood on where it was last seen: far from the robot, or "
        "beside or behind it",
        deadline_s=1.0,
    )

    def __init__(self, name: str, toolbox: Toolbox, wiring: Mapping[str, str] | None = None) -> None:
        super().__init__(name, toolbox, wiring, anything=True)

    def recall(self, item: SceneObject, category: Category) -> Status | Failure:
        """Tell what it stood on, unless that is before the robot."""
        toolbox = self.toolbox
        ahead_m, left_m = feet_pose(toolbox).sees(*map(float, item.world_T_object[:2, 3]))
        is_before = abs(math.atan2(left_m, ahead_m)) < toolbox.policy.beside_rad
        if is_before and math.hypot(ahead_m, left_m) < _FAR_M:
            return Failure.postcondition(f"where the {item.name} was is looked at from here")
        under = support_of(item, toolbox.world.scene, toolbox.policy.support_gap_m) if item.movable else None
        return super().recall(item, category) if under is None else super().recall(under, "furniture")
