"""What slips out of the hand on its way is looked for, picked up again, and carried on."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.failures import Failure, Reason
from trees.leaves.go_home import GoHome
from trees.nodes.judgements import judgement
from trees.nodes.retry import Retry
from trees.skills.looking.look_over import look_over
from trees.toolbox import Toolbox

# Something that slips twice needs another hand than this.
_ATTEMPTS = 2


def regrasping(carry: list[Behaviour], toolbox: Toolbox) -> Retry:
    """Get it and bring it there; once more when it was lost on the way.

    Args:
        carry: From getting it into a hand to having set it down.
        toolbox: Of the leaves that are added.
    """
    recover: list[Behaviour] = [GoHome("draw the empty hand in", toolbox), look_over(toolbox)]
    return Retry(
        "hold on to it",
        Sequence("carry it there", memory=True, children=carry),
        Sequence("look where it went", memory=True, children=recover),
        _ATTEMPTS,
        was_not_lost,
    )


@judgement
def was_not_lost(failure: Failure, _before: Failure | None) -> bool:
    """Only what was lost on the way can be picked up again."""
    link: Failure | None = failure
    while link is not None:
        if link.reason is Reason.SLIPPED:
            return False
        link = link.cause
    return True
