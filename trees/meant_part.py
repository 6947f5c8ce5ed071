"""Which door or drawer is meant, among several."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from trees.believed_thing import surroundings
from trees.failures import Failure
from trees.grounding import Ambiguous, Found, Missing, ground
from trees.handles import HandleTarget
from trees.odometry import feet_pose
from trees.questions import which_is_meant
from trees.tasks import ObjectDescription
from trees.toolbox import Toolbox


def meant_part(wanted: object, fitting: Sequence[HandleTarget], toolbox: Toolbox) -> HandleTarget | Failure:
    """The one that is described: "the top drawer", "the left door"; a question where several are.

    Args:
        wanted: What the task is about.
        fitting: At least one; each is in the planning scene.
        toolbox: Tells where the robot stands, and what is around it.
    """
    if len(fitting) == 1:
        return fitting[0]
    here, gap_m = feet_pose(toolbox).transform(), toolbox.policy.support_gap_m
    around = surroundings(toolbox.world.scene, here, gap_m)
    parts = {item.part: item for item in fitting}
    described = wanted if isinstance(wanted, ObjectDescription) else ObjectDescription()
    answer = ground(
        replace(described, name=None),
        around,
        among=[thing for thing in around.things if thing.name in parts],
    )
    match answer:
        case Ambiguous() as unclear:
            return which_is_meant(unclear)
        case Missing(message):
            return Failure.postcondition(message)
        case Found(names):
            return parts[names[0]]
