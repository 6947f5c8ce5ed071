"""The kinematic tree of a model for compiled code, flattened once for all stances."""

from __future__ import annotations

import functools
from typing import TYPE_CHECKING

from kinematics.robot_model import RobotModel

if TYPE_CHECKING:
    from kinematics.kernel.tree import Tree


@functools.lru_cache(maxsize=4)
def model_tree(model: RobotModel) -> Tree:
    """The tree of a model.

    Raises:
        ModelError: A joint is neither a floating base at the root nor a hinge or slide of one number.
    """
    # imported here: it brings the compiler
    from kinematics.kernel.tree import tree_of

    return tree_of(model.pin)
