"""What is seen in a hand is attached already, and must not become an obstacle as well."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from robots.perception.object_estimate import ObjectEstimate
from trees.toolbox import Toolbox


def not_in_hand(toolbox: Toolbox, estimates: Sequence[ObjectEstimate]) -> list[ObjectEstimate]:
    """Those estimates that are farther than ``same_object_m`` from everything that is held."""
    scene, q = toolbox.world.scene, toolbox.sensing.state().q
    held = [
        (toolbox.model.frame_pose(q, body.frame) @ body.frame_T_object)[:3, 3]
        for body in scene.attached.values()
    ]
    near = toolbox.policy.same_object_m
    return [
        estimate
        for estimate in estimates
        if all(float(np.linalg.norm(estimate.odom_T_object[:3, 3] - place)) > near for place in held)
    ]
