"""After a failed attempt at a pick: let go, get out of the way, and look again."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.composites import Sequence

from trees.failures import Failure, FailureKind
from trees.leaves.exclude_grasp import ExcludeGrasp
from trees.leaves.go_home import GoHome
from trees.leaves.release import Release
from trees.nodes.alternatives import Alternatives
from trees.nodes.best_effort import BestEffort
from trees.nodes.contract import Contract
from trees.nodes.judgements import looking_elsewhere_is_useless
from trees.nodes.leaf import DONE, Leaf
from trees.nodes.ports import optional, ports
from trees.nodes.skipping import OnlyAfter
from trees.port_values import Target
from trees.skills.looking.detect import Detect
from trees.skills.looking.look_at import LookAtTarget
from trees.skills.looking.search import search
from trees.skills.pick.back_out import BackOut
from trees.skills.pick.put_back import PutBack
from trees.toolbox import Toolbox


class ForgetTarget(Leaf):
    """Take the target out of the world model, after a look that should have shown it and did not.

    Otherwise the search that follows would take what it finds for a second object beside the target.
    """

    INPUT_PORTS = ports(target=optional(Target))
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="nobody knows where the target is",
        postcondition="the world model holds no target",
        deadline_s=1.0,
    )

    def step(self) -> Status | Failure:
        """Forget it, if it was ever seen."""
        target: Target | None = self.optional("target")
        world = self.toolbox.world
        if target is not None and target.name in world.scene.objects:
            world.update(world.scene.without_object(target.name))
        return DONE


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
