"""Walk to furniture, an object or a person."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.alternatives import defect
from trees.failures import Failure, FailureKind
from trees.leaves.go_home import GoHome
from trees.leaves.squared_up import SquaredUp
from trees.leaves.walk_to import WalkTo
from trees.retry import Retry
from trees.subtrees.search_place import everywhere, search_place
from trees.subtrees.tidily import tidily
from trees.toolbox import Toolbox


def walk_to(toolbox: Toolbox) -> Behaviour:
    """Find it, walk there, look again, and correct. Reads "task", writes "evidence"."""
    attempt = Sequence(
        "attempt",
        memory=True,
        children=[
            GoHome("stand upright", toolbox),
            WalkTo("walk", toolbox),
            search_place("look again", toolbox, everywhere(toolbox)),
            SquaredUp("stand square", toolbox),
        ],
    )
    again = GoHome("stand upright", toolbox)
    tries = Retry("walks", attempt, again, toolbox.policy.walk_attempts, _another_walk_is_useless)
    children: list[Behaviour] = [search_place("find it", toolbox, everywhere(toolbox)), tries]
    return tidily("walk to", children, toolbox)


def _another_walk_is_useless(failure: Failure, _before: Failure | None) -> bool:
    """Only standing beside the place is put right by walking again."""
    return defect(failure) or failure.kind is not FailureKind.POSTCONDITION
