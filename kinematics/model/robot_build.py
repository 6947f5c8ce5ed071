"""What a robot's arrays are made from: two models of the same robot share what was made for one of them."""

from __future__ import annotations

from collections.abc import Hashable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import pinocchio as pin

from kinematics.model.derived import Derivable, Recent
from kinematics.model.robot_model import RobotModel

if TYPE_CHECKING:
    from kinematics.model.tree import Tree


def model_tree(model: RobotModel) -> Tree:
    """The tree of a model.

    Raises:
        ModelError: A joint is neither a floating base at the root nor a hinge or slide of one number.
    """
    return model.derived(_tree)


def _tree(model: RobotModel) -> Tree:
    # imported here: it brings the compiler
    from kinematics.model.tree import tree_of

    return tree_of(model.pin)


def planning_memory(model: RobotModel) -> pin.Data:
    """The memory of a model; to make it takes as long as thirty evaluations with it."""
    return model.derived(_memory)


def _memory(model: RobotModel) -> pin.Data:
    return model.pin.createData()


@dataclass(frozen=True, slots=True)
class RobotBuild(Derivable):
    """A robot that is compared by what it is built of, and keeps what was made of that; see ``derived``.

    Attributes:
        made_from: Equal for robots with the same tree, shapes and loads.
        model: One of them.
    """

    made_from: Hashable
    model: RobotModel = field(compare=False)
    _derived: dict[Hashable, Any] = field(init=False, repr=False, compare=False, default_factory=dict)


def robot_build(model: RobotModel) -> RobotBuild:
    """What a model is built of: the same value for all models that are built alike."""
    return model.derived(_build)


def _build(model: RobotModel) -> RobotBuild:
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
    return _BUILDS.of(made_from, lambda: RobotBuild(made_from, model.twin()))


_KEPT = 3
"""A robot with empty hands, and with what they hold: each weight that was felt makes another one."""
_BUILDS: Recent[Hashable, RobotBuild] = Recent(_KEPT)
"""With models of their own: somebody's model keeps what was made for all places where that one has stood."""
