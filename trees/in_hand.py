"""What is seen in a hand is attached already, and must not become an obstacle as well."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np

from kinematics.scene import PlanningScene
from kinematics.support import support_of
from robots.perception.object_estimate import ObjectEstimate
from trees.policy import TreePolicy
from trees.scene_update import kind_of, scene_object, words_for
from trees.toolbox import Toolbox


def not_in_hand(toolbox: Toolbox, estimates: Sequence[ObjectEstimate]) -> list[ObjectEstimate]:
    """Those estimates that are of nothing that a hand holds.

    What is nearer than ``same_object_m`` to what is held is that. So is what looks like it, hangs in the air
    and is nearer than ``slid_m``: it has slid in the hand, or was seen while an encoder was off. Believed as
    a second one it would bar every way of that hand.
    """
    scene, policy = toolbox.world.scene, toolbox.policy
    if not scene.attached:
        return list(estimates)
    q = toolbox.sensing.state().q
    held = {
        name: (toolbox.model.frame_pose(q, body.frame) @ body.frame_T_object)[:3, 3]
        for name, body in scene.attached.items()
    }
    around = _with_furniture(scene, estimates, policy)
    return [
        estimate
        for estimate in estimates
        if all(
            float(np.linalg.norm(estimate.odom_T_object[:3, 3] - place))
            > (policy.slid_m if _hangs_like(name, estimate, around, policy) else policy.same_object_m)
            for name, place in held.items()
        )
    ]


def _hangs_like(held: str, estimate: ObjectEstimate, around: PlanningScene, policy: TreePolicy) -> bool:
    """Whether something looks like what is held and stands on nothing."""
    if words_for(estimate) != kind_of(held):
        return False
    return support_of(scene_object(held, estimate, policy), around, policy.support_gap_m) is None


def _with_furniture(
    scene: PlanningScene, estimates: Iterable[ObjectEstimate], policy: TreePolicy
) -> PlanningScene:
    """What is believed, and the furniture of this look, as it is seen now."""
    seen = (estimate for estimate in estimates if estimate.category == "furniture")
    tops = [scene_object(f"seen {number}", estimate, policy) for number, estimate in enumerate(seen)]
    return scene.with_objects([*scene.objects.values(), *tops])
