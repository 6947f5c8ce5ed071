"""A posture to take from where the robot stands now."""

from __future__ import annotations

from collections.abc import Mapping

from kinematics.requests.move import MoveRequest
from trees.toolbox import Toolbox


def move_from_here(
    toolbox: Toolbox,
    joints: Mapping[str, float] | None = None,
    keep_others: bool = False,
    pelvis_m: tuple[float, float, float] = (0.0, 0.0, 0.0),
) -> MoveRequest:
    """Ask for a move from the posture that is commanded, amid what is believed.

    Args:
        toolbox: Knows both, and deals the seed.
        joints, keep_others, pelvis_m: As for ``MoveRequest``.
    """
    return MoveRequest(
        q_start=toolbox.motion.reference(),
        stance=toolbox.motion.stance(),
        scene=toolbox.world.scene,
        joints=joints or {},
        keep_others=keep_others,
        pelvis_m=pelvis_m,
        seed=int(toolbox.rng.integers(2**31)),
    )
