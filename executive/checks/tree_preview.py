"""The tree that a task would run on the usual robot, without one: its leaves are made, and never ticked."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any, cast

import numpy as np

from executive.errors import UserError
from executive.runs.run_request import DEFAULT_ROBOT
from robots.models.description import load_description
from trees.btcpp.errors import TreeDocumentError
from trees.btcpp.reader import read_tree
from trees.btcpp.writer import write_tree
from trees.build import build_tree
from trees.nodes.snapshot_of import snapshot_of
from trees.snapshot import TreeSnapshot
from trees.tasks import Task
from trees.toolbox import Toolbox
from trees.world_model import WorldModel


def preview(task: Task) -> TreeSnapshot:
    """The tree before its first tick."""
    return build_tree(task, _nowhere()).snapshot(0.0)


def preview_document(task: Task) -> str:
    """The tree as a document of BehaviorTree.CPP 4.

    Raises:
        UserError: Something in it has no name that could be read again, as in a skill from outside.
    """
    try:
        return write_tree(build_tree(task, _nowhere()).root)
    except TreeDocumentError as wrong:
        raise UserError(f"the tree of {task.action!r} cannot be written: {wrong}") from wrong


def preview_of_document(text: str, source: str) -> TreeSnapshot:
    """The tree that a document of BehaviorTree.CPP 4 describes.

    Raises:
        UserError: It describes none that could run here.
    """
    return TreeSnapshot(0.0, 0, snapshot_of(_read(text, source)))


def rewritten_document(text: str, source: str) -> str:
    """The tree of a document, written anew.

    Raises:
        UserError: It describes none that could run here.
    """
    return write_tree(_read(text, source))


def _read(text: str, source: str) -> Any:
    try:
        return read_tree(text, _nowhere())
    except TreeDocumentError as wrong:
        raise UserError(f"{source}: {wrong}") from wrong


def _nowhere() -> Toolbox:
    absent = cast(Any, None)
    return Toolbox(
        clock=absent,
        model=cast(Any, SimpleNamespace(description=load_description(DEFAULT_ROBOT))),
        motion=absent,
        sensing=absent,
        grippers={},
        detector=absent,
        planning=absent,
        world=WorldModel(),
        events=lambda _event: None,
        rng=np.random.default_rng(0),
    )
