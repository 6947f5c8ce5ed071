"""Walk behind a person."""

from __future__ import annotations

from py_trees.behaviour import Behaviour

from trees.failures import Failure, Reason
from trees.leaves.go_home import tidily
from trees.nodes.best_effort import BestEffort
from trees.nodes.judgements import judgement
from trees.nodes.retry import Retry
from trees.skills.follow.look_round import look_round
from trees.skills.follow.settings import FollowSettings
from trees.skills.follow.walk_behind import WalkBehind
from trees.skills.searching.look_elsewhere import found_by_turning
from trees.skills.walking.draw_arms_in import DrawArmsIn
from trees.skills.walking.ready_to_walk import ReadyToWalk
from trees.toolbox import Toolbox


def follow(toolbox: Toolbox) -> Behaviour:
    """Find the person, walk behind, look round where the person is lost. Reads "task", writes "evidence"."""
    policy = toolbox.policy
    settings = policy.of(FollowSettings)
    behind = Retry(
        "keep behind",
        WalkBehind("walk behind", toolbox),
        look_round("look round", toolbox),
        settings.losses + 1,
        nobody_is_lost,
    )
    children: list[Behaviour] = [
        ReadyToWalk("stand upright", toolbox),
        BestEffort(DrawArmsIn("draw the arms in", toolbox)),
        found_by_turning("find the person", toolbox, policy.level_gazes),
        behind,
        BestEffort(DrawArmsIn("let the arms out", toolbox, out=True)),
    ]
    return tidily("follow", children, toolbox, settings.longest_s + policy.walk_timeout_s)


@judgement
def nobody_is_lost(failure: Failure, _before: Failure | None) -> bool:
    """Looking round helps where the person went out of sight, and nowhere else."""
    return failure.root.reason is not Reason.PERSON_LOST
