"""Turn a knob: look, plan, reach, take hold, turn, let go, and look again."""

from __future__ import annotations

from collections.abc import Sequence as Many

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.failures import Failure
from trees.leaves.check_trajectory import CheckTrajectory
from trees.leaves.exclude_grasp import ExcludeGrasp
from trees.leaves.go_home import GoHome
from trees.leaves.release import Release
from trees.leaves.stream_motion import StreamMotion
from trees.nodes.alternatives import Alternatives
from trees.nodes.best_effort import BestEffort
from trees.nodes.clean_up import CleanUp
from trees.nodes.deadline import Deadline
from trees.nodes.judgements import defect, judgement, tidying_helps
from trees.nodes.retry import Retry
from trees.policy import Gaze
from trees.skills.controls.detect_control import DetectControl, VerifyKnob
from trees.skills.controls.fingers import CloseOnKnob
from trees.skills.controls.plan_control import PlanControl, PlanTurn
from trees.skills.controls.press_in import DrawBackFrom
from trees.skills.looking.look_at import LookAt
from trees.toolbox import Toolbox

ATTEMPTS = 3
GAZES = (
    Gaze("ahead", tilt_rad=0.6),
    Gaze("left", tilt_rad=0.5, pan_rad=0.5),
    Gaze("right", tilt_rad=0.5, pan_rad=-0.5),
    Gaze("low", tilt_rad=0.77),
    Gaze("level", tilt_rad=0.3),
)
"""Knobs and buttons are before the chest, an arm's length away at most."""


def turn_knob(toolbox: Toolbox) -> Behaviour:
    """The whole skill. Reads "task" of the tree's namespace, writes "evidence"."""
    attempts = Retry("attempts", _attempt(toolbox), recover(toolbox), ATTEMPTS, turning_again_is_useless)
    so = sequence("see whether it is so already", VerifyKnob("verify", toolbox))
    ways = Alternatives("unless it is so", [so, attempts])
    main = sequence("turn it", looking(toolbox), ways)
    return tidy(toolbox, "turn knob", main)


def tidy(toolbox: Toolbox, name: str, main: Behaviour) -> Behaviour:
    """A skill in its time, with the hand away from what it was at, whatever goes wrong."""
    timed = Deadline("in time", main, toolbox.policy.task_timeout_s, toolbox.clock, toolbox.pauses)
    leave = sequence(
        "give up",
        BestEffort(Release("release", toolbox)),
        BestEffort(DrawBackFrom("draw back", toolbox)),
        BestEffort(GoHome("go home", toolbox)),
    )
    return CleanUp(name, timed, leave, worth_it=tidying_helps)


def sequence(name: str, *children: Behaviour) -> Sequence:
    """Children in order, each once."""
    return Sequence(name, memory=True, children=list(children))


def looking(toolbox: Toolbox, gazes: Many[Gaze] = GAZES) -> Behaviour:
    """Look until the one that is meant is seen."""
    looks = [
        sequence(f"look {gaze.name}", LookAt("look", toolbox, gaze), DetectControl("detect control", toolbox))
        for gaze in gazes
    ]
    return Alternatives("look for it", looks, hopeless=what_was_seen_of_it_decides)


def planned(toolbox: Toolbox, steps: Many[str]) -> Behaviour:
    """Plan the whole way, and check what is streamed of it."""
    return sequence("plan", PlanControl("plan control", toolbox), *checked(toolbox, steps))


def checked(toolbox: Toolbox, steps: Many[str]) -> list[CheckTrajectory]:
    """What judges some steps."""
    return [
        CheckTrajectory(f"check {step}", toolbox, {"step": step, "checked": f"checked_{step}"})
        for step in steps
    ]


def _attempt(toolbox: Toolbox) -> Behaviour:
    stream = {
        step: StreamMotion(f"stream {step}", toolbox, {"checked": f"checked_{step}"})
        for step in ("reach", "approach", "turn", "back")
    }
    return sequence(
        "attempt",
        planned(toolbox, ("reach", "approach")),
        sequence("come", Release("open gripper", toolbox), stream["reach"], stream["approach"]),
        sequence("hold", CloseOnKnob("close on it", toolbox)),
        sequence(
            "turn",
            PlanTurn("plan turn", toolbox),
            *checked(toolbox, ("turn", "back")),
            stream["turn"],
        ),
        sequence("let go", Release("release", toolbox), stream["back"], GoHome("go home", toolbox)),
        verified(toolbox),
    )


def verified(toolbox: Toolbox) -> Behaviour:
    """Look again, and see how far it is turned."""
    looks = [
        sequence(f"look {gaze.name}", LookAt("look", toolbox, gaze), VerifyKnob("verify", toolbox))
        for gaze in GAZES
    ]
    return Alternatives("verify", looks, hopeless=what_was_seen_of_it_decides)


def recover(toolbox: Toolbox) -> Behaviour:
    """Let go, draw back, go home, and look where it is now."""
    return sequence(
        "recover",
        ExcludeGrasp("exclude grasp", toolbox, {"tried_now": "tried"}),
        BestEffort(Release("release", toolbox)),
        BestEffort(DrawBackFrom("draw back", toolbox)),
        BestEffort(GoHome("go home", toolbox)),
        BestEffort(looking(toolbox)),
    )


@judgement
def what_was_seen_of_it_decides(failure: Failure) -> bool:
    """A defect or a question: another look shows the same."""
    return defect(failure) or bool(failure.choices)


@judgement
def turning_again_is_useless(failure: Failure, before: Failure | None) -> bool:
    """A defect, a question, or the planner's no."""
    return defect(failure) or bool(failure.choices) or (before is not None and before.kind is failure.kind)
