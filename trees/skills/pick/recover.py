"""After a failed attempt at a pick: let go, get out of the way, and look again."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.failures import FailureKind
from trees.leaves.exclude_grasp import ExcludeGrasp
from trees.leaves.go_home import GoHome
from trees.leaves.release import Release
from trees.nodes.alternatives import Alternatives
from trees.nodes.best_effort import BestEffort
from trees.nodes.judgements import looking_elsewhere_is_useless
from trees.nodes.skipping import OnlyAfter
from trees.skills.looking.detect import Detect
from trees.skills.looking.look_at import LookAtTarget
from trees.skills.looking.search import search
from trees.skills.pick.back_out import BackOut
from trees.skills.pick.forget_target import ForgetTarget
from trees.skills.pick.put_back import PutBack
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
