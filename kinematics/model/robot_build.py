"""What a robot's arrays are made from: two models of the same robot share what was made for one of them."""

from __future__ import annotations

import functools
from typing import TYPE_CHECKING

import pinocchio as pin

from kinematics.model.robot_model import RobotModel

if TYPE_CHECKING:
    from kinematics.model.tree import Tree

from collections.abc import Hashable
from dataclasses import dataclass, field


@functools.lru_cache(maxsize=4)
def model_tree(model: RobotModel) -> Tree:
    """The tree of a model.

    Raises:
        ModelError: A joint is neither a floating base at the root nor a hinge or slide of one number.
    """
    # imported here: it brings the compiler
    from kinematics.model.tree import tree_of

    return tree_of(model.pin)


@functools.lru_cache(maxsize=4)
def planning_memory(model: RobotModel) -> pin.Data:
    """The memory of a model; to make it takes as long as thirty evaluations with it."""
    return model.pin.createData()


@dataclass(frozen=True, slots=True)
class RobotBuild:
    """A robot that is compared by what it is built of, for tables of what was made once.

    Attributes:
        made_from: Equal for robots with the same tree, shapes and loads.
        model: One of them.
    """

    made_from: Hashable
    model: RobotModel = field(compare=False)


@functools.lru_cache(maxsize=8)
def robot_build(model: RobotModel) -> RobotBuild:
    """What a model is built of."""
    robot = model.description
    made_from = (
        robot.planning_urdf,
        frozenset(frozenset(pair) for pair in robot.disabled_collisions),
        tuple((name, tuple(joints)) for name, joints in sorted(robot.groups.items())),
        tuple((hand, repr(gripper)) for hand, gripper in sorted(robot.grippers.items())),
        (robot.welded, *robot.mount_xyz_m, *robot.mount_rpy_rad),
        # what is carried belongs to the model, not to the robot's data
        b"".join(inertia.toDynamicParameters().tobytes() for inertia in model.pin.inertias),
    )
    return RobotBuild(made_from, model)
