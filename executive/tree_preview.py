"""The tree that a task would run, without a robot: its leaves are made, and never ticked."""

from __future__ import annotations

from typing import Any, cast

import numpy as np

from trees.build import build_tree
from trees.snapshot import TreeSnapshot
from trees.tasks import Task
from trees.toolbox import Toolbox
from trees.world_model import WorldModel


def preview(task: Task) -> TreeSnapshot:
    """The tree before its first tick."""
    absent = cast(Any, None)
    toolbox = Toolbox(
        clock=absent,
        model=absent,
        motion=absent,
        sensing=absent,
        grippers={},
        detector=absent,
        planning=absent,
        world=WorldModel(),
        events=lambda _event: None,
        rng=np.random.default_rng(0),
    )
    return build_tree(task, toolbox).snapshot(0.0)
