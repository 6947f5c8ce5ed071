"""The arms that hold nothing: whether they are drawn in, and what draws them in or lets them out."""

from __future__ import annotations

from collections.abc import Mapping

from trees.toolbox import Toolbox

_THERE_RAD = 0.05
"""A joint that is told to be so near to where it is wanted is there."""


def tucked_joints(toolbox: Toolbox) -> Mapping[str, float]:
    """Where the joints of empty arms are when they are drawn in, rad; none where they cannot be."""
    walking = toolbox.model.description.walking
    if walking is None or walking.tucked is None:
        return {}
    tucked = walking.tucked.joints
    return {name: tucked[name] for name in _empty_arm_joints(toolbox) if name in tucked}


def home_joints(toolbox: Toolbox) -> Mapping[str, float]:
    """Where they are at home, rad."""
    home = toolbox.model.description.home
    return {name: home[name] for name in _empty_arm_joints(toolbox)}


def are_at(toolbox: Toolbox, joints: Mapping[str, float]) -> bool:
    """Whether joints are told to be at some positions, all of them."""
    model, q = toolbox.model, toolbox.motion.reference()
    return all(abs(q[7 + model.joint_index(name)] - at) <= _THERE_RAD for name, at in joints.items())


def arms_are_tucked(toolbox: Toolbox) -> bool:
    """Whether every arm that holds nothing is drawn in; not so if there is none."""
    joints = tucked_joints(toolbox)
    return bool(joints) and are_at(toolbox, joints)


def _empty_arm_joints(toolbox: Toolbox) -> list[str]:
    description = toolbox.model.description
    frames = {body.frame for body in toolbox.world.scene.attached.values()}
    return [
        joint
        for hand, frame in description.tcp_frames.items()
        if frame not in frames
        for joint in description.groups[f"{hand}_arm"]
    ]
