"""Open or close a door or drawer: look, plan, reach, take hold, lead, let go, and look again."""

from __future__ import annotations

from collections.abc import Sequence as Many

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.failures import Failure, FailureKind, Reason
from trees.leaves.check_trajectory import CheckTrajectory
from trees.leaves.exclude_grasp import ExcludeGrasp
from trees.leaves.go_home import GoHome
from trees.leaves.release import Release
from trees.nodes.alternatives import Alternatives
from trees.nodes.best_effort import BestEffort
from trees.nodes.clean_up import CleanUp
from trees.nodes.deadline import Deadline
from trees.nodes.judgements import defect, judgement, tidying_helps
from trees.nodes.retry import Retry
from trees.policy import Gaze
from trees.skills.doors.choose_handle import ChooseHandle
from trees.skills.doors.come_to_handle import come_to_handle, is_known_by_a_model, stand_aside
from trees.skills.doors.detect_handle import DetectHandle
from trees.skills.doors.find_handle import seen_from_elsewhere
from trees.skills.doors.handle.approach_handle import ApproachHandle
from trees.skills.doors.handle.grasp_handle import GraspHandle
from trees.skills.doors.handle.lead_handle import LeadHandle, is_stuck, slips_off
from trees.skills.doors.handle.step_back import StepBack
from trees.skills.doors.look_at_handle import LookAtHandle
from trees.skills.doors.names_door import NamesDoor
from trees.skills.doors.plan_handle import PlanHandle
from trees.skills.doors.reach_watching import ReachWatching
from trees.skills.doors.verify_opening import IsItSo, VerifyOpening
from trees.skills.looking.look_at import LookAt
from trees.skills.looking.survey import Survey
from trees.toolbox import Toolbox

ATTEMPTS = 3
GAZES = (
    Gaze("ahead", tilt_rad=0.6),
    Gaze("left", tilt_rad=0.5, pan_rad=0.5),
    Gaze("right", tilt_rad=0.5, pan_rad=-0.5),
    Gaze("low", tilt_rad=0.77),
    Gaze("far left", tilt_rad=0.6, pan_rad=0.9),
    Gaze("far right", tilt_rad=0.6, pan_rad=-0.9),
    Gaze("down left", tilt_rad=0.7, pan_rad=0.7, lean_rad=0.3),
    Gaze("down right", tilt_rad=0.7, pan_rad=-0.7, lean_rad=0.3),
    Gaze("beside left", tilt_rad=0.7, pan_rad=1.2),
    Gaze("beside right", tilt_rad=0.7, pan_rad=-1.2),
)
"""Handles are before the chest, up to an arm's length to the sides."""
_BESIDE, _BELOW_BESIDE = GAZES[4:6], GAZES[6:8]
"""With what was seen ahead: no door, and no drawer that is open before the body, is left out."""


def open_or_close(toolbox: Toolbox) -> Behaviour:
    """The whole skill. Reads "task" of the tree's namespace, writes "evidence"."""
    attempts = Retry("attempts", _attempt(toolbox), _recover(toolbox), ATTEMPTS, moving_it_again_is_useless)
    come = come_to_handle(toolbox, lambda name: _search(name, toolbox))
    do = _Sequence("come and move it", memory=True, children=[come, attempts])
    do.transparent = True
    ways = Alternatives("unless it is so", [IsItSo("see whether it is so already", toolbox), do])
    ways.transparent = True
    settled = choose_which(toolbox, DetectHandle, pushed=False)
    main = _Sequence("move the handle", memory=True, children=[_search_about(toolbox), settled, ways])
    main.transparent = True
    timed = Deadline("in time", main, time_limit_s(toolbox), toolbox.clock, toolbox.pauses)
    return CleanUp("open or close", timed, _leave(toolbox), worth_it=tidying_helps)


def time_limit_s(toolbox: Toolbox) -> float:
    """What it takes at most: a robot that walks may have to look to all sides, and to go there."""
    policy = toolbox.policy
    return policy.task_timeout_s + (policy.walk_timeout_s if toolbox.can_walk else 0.0)


class _Sequence(Sequence):
    """A sequence that may be left out of places in the tree."""

    transparent = False


def sequence(name: str, *children: Behaviour) -> _Sequence:
    """Children in order, each once."""
    return _Sequence(name, memory=True, children=list(children))


def _search_about(toolbox: Toolbox) -> Alternatives:
    """Look from here, and from elsewhere where the robot can walk."""
    return seen_from_elsewhere(
        "search", toolbox, lambda name, gazes: _search(name, toolbox, gazes), GAZES, pushed=False
    )


def _search(name: str, toolbox: Toolbox, gazes: Many[Gaze] = GAZES) -> Alternatives:
    """Look until the handle is seen; where one is known to be first."""
    looks = [
        sequence(
            "look there", LookAtHandle("look", toolbox, between=0.0), DetectHandle("detect handle", toolbox)
        ),
        *(
            sequence(
                f"look {gaze.name}", LookAt("look", toolbox, gaze), DetectHandle("detect handle", toolbox)
            )
            for gaze in gazes
        ),
    ]
    return Alternatives(name, looks, hopeless=what_was_seen_decides)


def choose_which(toolbox: Toolbox, detect: type[DetectHandle], *, pushed: bool) -> Behaviour:
    """Look to both sides of the robot, choose among all that is known by then, and look at the chosen one."""
    doors, drawers = _looks_beside(toolbox, _BESIDE), _looks_beside(toolbox, _BELOW_BESIDE)
    ways = [sequence("doors", NamesDoor("is it a door", toolbox), *doors), sequence("drawers", *drawers)]
    beside = Alternatives("look beside", ways, hopeless=defect)
    there = sequence("look there", LookAtHandle("look", toolbox, between=0.0), detect("detect", toolbox))
    choose = ChooseHandle("choose", toolbox, pushed=pushed)
    return sequence("see which", beside, choose, BestEffort(there))


def _looks_beside(toolbox: Toolbox, gazes: Many[Gaze]) -> list[Behaviour]:
    return [
        BestEffort(
            sequence(
                f"look {gaze.name}",
                LookAt("look", toolbox, gaze),
                Survey("survey", toolbox, {"sightings_now": "sightings"}),
            )
        )
        for gaze in gazes
    ]


def planned(name: str, toolbox: Toolbox) -> Behaviour:
    """Plan the whole way, and check what is streamed of it."""
    return sequence(
        "plan",
        PlanHandle(name, toolbox),
        CheckTrajectory("check reach", toolbox, {"step": "reach", "checked": "checked_reach"}),
        CheckTrajectory("check approach", toolbox, {"step": "approach", "checked": "checked_approach"}),
    )


def _attempt(toolbox: Toolbox) -> Behaviour:
    move = sequence(
        "move",
        planned("plan handle", toolbox),
        sequence(
            "reach",
            Release("open gripper", toolbox),
            ReachWatching("stream reach", toolbox, {"checked": "checked_reach"}),
            ApproachHandle("approach", toolbox),
        ),
        sequence("grasp", GraspHandle("grasp handle", toolbox)),
        sequence("lead", LeadHandle("lead handle", toolbox)),
        sequence("let go", Release("release", toolbox, at_bar=True), StepBack("step back", toolbox)),
        sequence("leave", *going(toolbox)),
        verify(toolbox),
    )
    move.transparent = True
    attempt = Alternatives("attempt", [IsItSo("see whether it is so", toolbox), move])
    attempt.transparent = True
    return attempt


def verify(toolbox: Toolbox) -> Behaviour:
    """Look where the front should be, and measure how far it is open."""
    return Alternatives(
        "verify",
        [
            sequence("look there", LookAtHandle("look", toolbox), VerifyOpening("verify", toolbox)),
            *(
                sequence(f"look {gaze.name}", LookAt("look", toolbox, gaze), VerifyOpening("verify", toolbox))
                for gaze in GAZES[:3]
            ),
        ],
        hopeless=seen_already,
    )


@judgement
def seen_already(failure: Failure) -> bool:
    """What was seen stands: from elsewhere it may be out of sight, and the hand's word is a worse one."""
    return defect(failure) or failure.root.reason is Reason.SEEN_NOT_AS_ASKED


def going(toolbox: Toolbox, detect: type[DetectHandle] = DetectHandle) -> list[Behaviour]:
    """See where the door is now, for the arm has to get past it, and go home.

    A door that stands wide open may be where a hand is at home; then the arm stays clear of it where it is.
    """
    seen = sequence("see it", LookAtHandle("look", toolbox), detect("detect", toolbox, _ELSEWHERE))
    clear = BestEffort(StepBack("step clear", toolbox, clear=True))
    return [clear, BestEffort(seen), BestEffort(GoHome("go home", toolbox))]


_ELSEWHERE = {"handle": "handle_now"}
"""What is seen on the way back must not replace what was planned for."""


def _recover(toolbox: Toolbox) -> Behaviour:
    """Let go, draw back, go home, and look where it is now."""
    return sequence(
        "recover",
        ExcludeGrasp("exclude grasp", toolbox, {"tried_now": "tried"}),
        Release("release", toolbox, at_bar=True),
        BestEffort(StepBack("step back", toolbox)),
        BestEffort(sequence("leave", *going(toolbox))),
        BestEffort(_search("look again", toolbox)),
        BestEffort(
            Alternatives(
                "stand elsewhere",
                [stand_aside(toolbox, lambda name: _search(name, toolbox))],
                worth_trying=is_known_by_a_model,
            )
        ),
    )


def _leave(toolbox: Toolbox) -> Behaviour:
    """Whatever went wrong: the hand is free of the handle and the robot stands at home."""
    return sequence(
        "give up",
        BestEffort(Release("release", toolbox, at_bar=True)),
        BestEffort(StepBack("step back", toolbox)),
        *going(toolbox),
    )


@judgement
def what_was_seen_decides(failure: Failure) -> bool:
    """A defect, or what was seen decides that it cannot be done: another look shows the same."""
    return defect(failure) or failure.kind is FailureKind.INFEASIBLE


@judgement
def moving_it_again_is_useless(failure: Failure, before: Failure | None) -> bool:
    """A defect, the planner's no twice in a row, or something that is stuck: pulling again opens no lock."""
    twice = before is not None and before.kind is failure.kind is FailureKind.INFEASIBLE
    stuck = is_stuck(failure) and (not slips_off(failure) or (before is not None and slips_off(before)))
    return defect(failure) or bool(failure.choices) or twice or stuck
