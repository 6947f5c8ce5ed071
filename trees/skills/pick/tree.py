"""Pick an object up: search, plan, check, reach, confirm, approach, grasp, lift, verify, and recover.

The dry run looks, plans and checks the same, and moves nothing.
"""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.leaves.check_trajectory import CheckTrajectory
from trees.leaves.go_home import GoHome
from trees.leaves.release import Release
from trees.leaves.stream_motion import StreamMotion
from trees.nodes.best_effort import BestEffort
from trees.nodes.clean_up import CleanUp
from trees.nodes.deadline import Deadline
from trees.nodes.judgements import no_other_attempt_helps, tidying_helps
from trees.nodes.retry import Retry
from trees.nodes.skipping import UnlessHeld
from trees.skills.looking.detect import Detect
from trees.skills.looking.find_unseen import FindUnseenOnWay
from trees.skills.looking.look_along_way import seen_way
from trees.skills.looking.look_at import LookAtTarget
from trees.skills.looking.search import search_from_home_too
from trees.skills.pick.attach import Attach
from trees.skills.pick.back_out import BackOut
from trees.skills.pick.close_gripper import CloseGripper
from trees.skills.pick.confirm_target import ConfirmTarget
from trees.skills.pick.hand_for_it import HandForIt
from trees.skills.pick.lift_wholly import LiftWholly
from trees.skills.pick.open_gripper import OpenGripper
from trees.skills.pick.plan_pick import PlanPick
from trees.skills.pick.put_back import PutBack
from trees.skills.pick.recover import recover
from trees.skills.pick.settings import PickSettings
from trees.skills.pick.verify_hold import VerifyHold
from trees.skills.pick.verify_lift import VerifyLift
from trees.task_tree import TaskTree
from trees.tasks import PickTask, Task
from trees.toolbox import Toolbox

_LOOKS_ON_WAY = 3
"""One for the first plan, one for the other hand, and one for what was found on its way."""


def pick(toolbox: Toolbox) -> Behaviour:
    """The whole skill, unless it is held already. Reads "task" of the tree's namespace, writes "evidence".

    What a cancelled pick has lifted a little is lifted wholly.
    """
    root = _sequence(
        "pick",
        HandForIt("a hand for it", toolbox),
        UnlessHeld(_fetched(toolbox)),
        LiftWholly("lift it wholly", toolbox),
    )
    root.transparent = True
    return root


def _fetched(toolbox: Toolbox) -> CleanUp:
    attempts = Retry(
        "attempts",
        _attempt(toolbox),
        recover(toolbox),
        toolbox.policy.of(PickSettings).pick_attempts,
        no_other_attempt_helps,
    )
    main = _sequence("pick up", search_from_home_too(toolbox), attempts)
    main.transparent = True
    timed = Deadline("in time", main, toolbox.policy.task_timeout_s, toolbox.clock, toolbox.pauses)
    return CleanUp("pick", timed, _give_up(toolbox), worth_it=tidying_helps)


class _Sequence(Sequence):
    """A sequence that may be left out of places in the tree."""

    transparent = False


def _sequence(name: str, *children: Behaviour) -> _Sequence:
    return _Sequence(name, memory=True, children=list(children))


def _attempt(toolbox: Toolbox) -> Behaviour:
    attempt = _sequence(
        "attempt",
        _sequence(
            "plan",
            PlanPick("plan pick", toolbox),
            seen_way(
                "look where the hand goes",
                toolbox,
                FindUnseenOnWay,
                lambda: PlanPick("plan again", toolbox),
                _LOOKS_ON_WAY,
            ),
            CheckTrajectory("check reach", toolbox, {"step": "reach", "checked": "checked_reach"}),
            CheckTrajectory("check approach", toolbox, {"step": "approach", "checked": "checked_approach"}),
            CheckTrajectory("check lift", toolbox, {"step": "lift", "checked": "checked_lift"}),
        ),
        _sequence(
            "reach",
            OpenGripper("open gripper", toolbox),
            StreamMotion("stream reach", toolbox, {"checked": "checked_reach"}),
        ),
        _sequence("confirm", ConfirmTarget("confirm target", toolbox)),
        _sequence("approach", StreamMotion("stream approach", toolbox, {"checked": "checked_approach"})),
        _sequence(
            "grasp",
            CloseGripper("close gripper", toolbox),
            VerifyHold("verify hold", toolbox),
            Attach("attach", toolbox),
        ),
        _sequence(
            "lift",
            CheckTrajectory("check trajectory", toolbox, {"step": "held_lift", "checked": "checked_lift"}),
            StreamMotion("stream lift", toolbox, {"checked": "checked_lift"}),
            LookAtTarget("look", toolbox),
            VerifyLift("verify lift", toolbox),
        ),
    )
    attempt.transparent = True
    return attempt


def _give_up(toolbox: Toolbox) -> Behaviour:
    """Leave nothing behind: what is held is put back if that works, and kept if it does not."""
    return _sequence(
        "give up",
        BestEffort(PutBack("put back", toolbox)),
        BestEffort(Release("release", toolbox)),
        BestEffort(BackOut("back out", toolbox)),
        GoHome("go home", toolbox),
    )


def build_dry_run(task: Task, toolbox: Toolbox) -> TaskTree:
    """Build the dry run of a task, from where the robot stands and looks now.

    Raises:
        TypeError: There is no dry run of such a task.
    """
    if not isinstance(task, PickTask):
        raise TypeError(f"no dry run of a {type(task).__name__}")
    children: list[Behaviour] = [Detect("detect", toolbox), PlanPick("plan pick", toolbox)]
    children += [
        CheckTrajectory(f"check {step}", toolbox, {"step": step, "checked": f"checked_{step}"})
        for step in ("reach", "approach", "lift")
    ]
    return TaskTree(task, Sequence("rehearsal", memory=True, children=children), toolbox)
