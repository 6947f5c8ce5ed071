"""After a failed attempt at a pick: let go, get out of the way, and look again."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.alternatives import Alternatives
from trees.best_effort import BestEffort
from trees.failures import FailureKind
from trees.leaves.back_out import BackOut
from trees.leaves.detect import Detect
from trees.leaves.exclude_grasp import ExcludeGrasp
from trees.leaves.forget_target import ForgetTarget
from trees.leaves.go_home import GoHome
from trees.leaves.look_at import LookAtTarget
from trees.leaves.put_back import PutBack
from trees.leaves.release import Release
from trees.only_after import OnlyAfter
from trees.subtrees.search import looking_elsewhere_is_useless, search
from trees.toolbox import Toolbox

# After these the posture itself is in question, or the hand leans on something: go home first.
_POSTURE_KINDS = frozenset(
    {FailureKind.INFEASIBLE, FailureKind.UNSAFE, FailureKind.REFUSED, FailureKind.EXECUTION}
)


def recover(toolbox: Toolbox) -> Behaviour:
    """Put back what is held, open the hand, back out, see where the object is now."""
    from_here: list[Behaviour] = [LookAtTarget("look", toolbox), Detect("detect", toolbox)]
    from_home: list[Behaviour] = [
        GoHome("go home", toolbox),
        ForgetTarget("forget target", toolbox),
        search("search", toolbox),
    ]
    children: list[Behaviour] = [
        ExcludeGrasp("exclude grasp", toolbox, {"tried_now": "tried"}),
        BestEffort(PutBack("put back", toolbox)),
        Release("release", toolbox),
        BestEffort(BackOut("back out", toolbox)),
        OnlyAfter(BestEffort(GoHome("go home", toolbox)), _POSTURE_KINDS),
        Alternatives(
            "look again",
            [
                Sequence("look from here", memory=True, children=from_here),
                Sequence("look from home", memory=True, children=from_home),
            ],
            hopeless=looking_elsewhere_is_useless,
        ),
    ]
    return Sequence("recover", memory=True, children=children)
