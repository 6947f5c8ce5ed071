"""Close a door by a push against its front, else by its handle; a drawer by its handle, or as a door."""

from __future__ import annotations

from collections.abc import Sequence as Many

from py_trees.behaviour import Behaviour

from trees.failures import Failure
from trees.leaves.exclude_grasp import ExcludeGrasp
from trees.nodes.alternatives import Alternatives
from trees.nodes.best_effort import BestEffort
from trees.nodes.clean_up import CleanUp
from trees.nodes.deadline import Deadline
from trees.nodes.judgements import defect, judgement, tidying_helps
from trees.nodes.retry import Retry
from trees.policy import Gaze
from trees.skills.doors.come_to_handle import come_to_handle
from trees.skills.doors.detect_handle import DetectFront
from trees.skills.doors.find_handle import seen_from_elsewhere
from trees.skills.doors.handle.approach_handle import ApproachHandle
from trees.skills.doors.handle.lead_handle import LeadHandle, is_stuck
from trees.skills.doors.handle.step_back import StepBack
from trees.skills.doors.handle.touch_front import TouchFront
from trees.skills.doors.names_door import NamesDoor
from trees.skills.doors.open import (
    ATTEMPTS,
    GAZES,
    choose_which,
    going,
    moving_it_again_is_useless,
    open_or_close,
    planned,
    sequence,
    time_limit_s,
    verify,
    what_was_seen_decides,
)
from trees.skills.doors.reach_watching import ReachWatching
from trees.skills.doors.verify_opening import IsItSo
from trees.skills.looking.look_at import LookAt
from trees.toolbox import Toolbox


def close(toolbox: Toolbox) -> Behaviour:
    """The whole skill. Reads "task" of the tree's namespace, writes "evidence"."""
    return Alternatives("close", [_push_shut(toolbox), open_or_close(toolbox)], hopeless=handle_is_no_help)


def _push_shut(toolbox: Toolbox) -> Behaviour:
    attempts = Retry("attempts", _attempt(toolbox), _recover(toolbox), ATTEMPTS, moving_it_again_is_useless)
    come = come_to_handle(toolbox, lambda name: _search(name, toolbox))
    settled = choose_which(toolbox, DetectFront, pushed=True)
    main = sequence("push the front", _search_about(toolbox), settled, come, attempts)
    timed = Deadline("in time", main, time_limit_s(toolbox), toolbox.clock, toolbox.pauses)
    tidy = CleanUp("push shut", timed, _leave(toolbox), worth_it=tidying_helps)
    if toolbox.model.description.pushing.drawers:
        return tidy
    return sequence("push", NamesDoor("names a door", toolbox), tidy)


def _search_about(toolbox: Toolbox) -> Alternatives:
    return seen_from_elsewhere(
        "search", toolbox, lambda name, gazes: _search(name, toolbox, gazes), GAZES, pushed=True
    )


def _search(name: str, toolbox: Toolbox, gazes: Many[Gaze] = GAZES) -> Alternatives:
    looks = [
        sequence(f"look {gaze.name}", LookAt("look", toolbox, gaze), DetectFront("detect front", toolbox))
        for gaze in gazes
    ]
    return Alternatives(name, looks, hopeless=what_was_seen_decides)


def _attempt(toolbox: Toolbox) -> Behaviour:
    move = sequence(
        "move",
        planned("plan push", toolbox),
        sequence(
            "push",
            ReachWatching("stream reach", toolbox, {"checked": "checked_reach"}),
            ApproachHandle("approach", toolbox),
            TouchFront("touch front", toolbox),
            LeadHandle("push front", toolbox),
        ),
        sequence("let go", StepBack("step back", toolbox)),
        sequence("leave", *going(toolbox, DetectFront)),
        verify(toolbox),
    )
    return Alternatives("attempt", [IsItSo("see whether it is so", toolbox), move])


def _recover(toolbox: Toolbox) -> Behaviour:
    recover = sequence(
        "recover",
        ExcludeGrasp("exclude place", toolbox, {"tried_now": "tried"}),
        BestEffort(StepBack("step back", toolbox)),
        BestEffort(sequence("leave", *going(toolbox, DetectFront))),
        BestEffort(_search("look again", toolbox)),
    )
    if toolbox.model.description.pushing.before_m is not None:  # which depends on how far it is open now
        recover.add_child(BestEffort(come_to_handle(toolbox, lambda name: _search(name, toolbox))))
    return recover


def _leave(toolbox: Toolbox) -> Behaviour:
    """Whatever went wrong: the hand is off the door and the robot stands at home."""
    return sequence("give up", BestEffort(StepBack("step back", toolbox)), *going(toolbox, DetectFront))


@judgement
def handle_is_no_help(failure: Failure) -> bool:
    """A defect, a question, or what does not give way: pulling a handle closes it no better than a push."""
    return defect(failure) or bool(failure.choices) or is_stuck(failure)
