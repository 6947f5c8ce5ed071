"""A leaf that plans one simple motion, has it checked, and makes it."""

from __future__ import annotations

from collections.abc import Mapping

from py_trees.common import Status

from kinematics.motion.verdict import CheckedTrajectory, Unsafe
from kinematics.requests.move import MovePlan, MoveRequest
from kinematics.requests.request import Request
from kinematics.requests.step import NoPlan
from robots.control.motion_handle import MotionHandle, MotionStatus
from trees.failures import Failure
from trees.nodes.arrival import arrival
from trees.nodes.leaf import DONE, RUNNING, Leaf
from trees.nodes.motion_leaf import motion_failure
from trees.nodes.plan_failures import no_plan_failure, unsafe_failure, why_stale
from trees.toolbox import Job, Toolbox


class PlannedMotionLeaf(Leaf):
    """A leaf that has one motion planned and checked, makes it, and measures that the joints have arrived.

    It is for motions that are a means to something else, such as looking somewhere, drawing a hand back, or
    going home.
    """

    _job: Job[MovePlan | NoPlan] | None = None
    _check: Job[CheckedTrajectory | Unsafe] | None = None
    _checked: CheckedTrajectory | None = None
    _handle: MotionHandle | None = None
    _arrived_by_s: float = 0.0
    _world_version: int = 0
    _refused: Failure | None = None
    _planned_anew: bool = False

    def goal(self) -> Request[MovePlan | NoPlan] | Failure | None:
        """What to plan; None when the robot is there already, or why there is nothing to plan."""
        raise NotImplementedError

    @property
    def deadline_s(self) -> float:
        """The contract's deadline, longer by the motion's own duration once that is known."""
        extra = 0.0 if self._checked is None else self._checked.trajectory.duration_s
        return self.CONTRACT.deadline_s + extra

    def begin(self) -> None:
        """Submit the planning job."""
        self._job = self._check = self._checked = self._handle = None
        self._world_version = self.toolbox.world.scene.version
        self._refused, self._planned_anew = None, False
        goal = self.goal()
        if isinstance(goal, Failure):
            self._refused = goal
        elif goal is not None:
            self._job = self.toolbox.planning.submit(goal)
            self.feedback_message = "planning"

    def step(self) -> Status | Failure:
        """Plan, check, move; whichever is under way."""
        if self._refused is not None:
            return self._refused
        if self._handle is not None:
            return self._follow(self._handle)
        if self._check is not None:
            return self._judged(self._check)
        if self._job is not None:
            return self._planned(self._job)
        self.feedback_message = "already there"
        return DONE

    def _planned(self, job: Job[MovePlan | NoPlan]) -> Status | Failure:
        """Have the plan checked, once it is there."""
        if not job.done:
            return RUNNING
        answer, self._job = job.result(), None
        if isinstance(answer, NoPlan):
            return no_plan_failure(answer)
        self._check = self.toolbox.planning.check(answer.step.question)
        self.feedback_message = "checking"
        return RUNNING

    def _judged(self, check: Job[CheckedTrajectory | Unsafe]) -> Status | Failure:
        """Begin the motion, once it is judged to be safe."""
        if not check.done:
            return RUNNING
        verdict, self._check = check.result(), None
        return self._once_more(verdict) if isinstance(verdict, Unsafe) else self._start(verdict)

    def release(self, reason: str) -> None:
        """Forget the job; brake and hold."""
        for job in (self._job, self._check):
            if job is not None:
                job.cancel()
        if self._handle is not None and not self._handle.finished:
            self.toolbox.motion.cancel(self._handle, reason)

    def _once_more(self, answer: Unsafe) -> Status | Failure:
        """A plan found by chance may be too near to something by a hair; another one seldom is."""
        goal = None if self._planned_anew else self.goal()
        if not isinstance(goal, MoveRequest):
            return unsafe_failure(self.name, answer)
        self._planned_anew, self._world_version = True, self.toolbox.world.scene.version
        self._job = self.toolbox.planning.submit(goal)
        self.feedback_message = "planning anew"
        return RUNNING

    def _start(self, checked: CheckedTrajectory) -> Status | Failure:
        stale = why_stale(self.name, self._world_version, self.toolbox.world.scene.version)
        if stale is not None:
            return stale
        self._checked = checked
        self._arrived_by_s = (
            self.elapsed_s + checked.trajectory.duration_s + self.toolbox.policy.motion_slack_s
        )
        self._handle = self.toolbox.motion.start(checked)
        return RUNNING

    def _follow(self, handle: MotionHandle) -> Status | Failure:
        if (ended := motion_failure(handle)) is not None:
            return ended
        if handle.status is MotionStatus.RUNNING:
            self.feedback_message = f"moving {handle.progress:.0%}"
            return RUNNING
        if self._checked is None:
            raise RuntimeError(f"{self.name} moves without a checked trajectory")
        self.feedback_message = "arrived"
        return arrival(self, self._checked, self._arrived_by_s)


def move_from_here(
    toolbox: Toolbox,
    joints: Mapping[str, float] | None = None,
    keep_others: bool = False,
    pelvis_m: tuple[float, float, float] = (0.0, 0.0, 0.0),
    level: bool = False,
) -> MoveRequest:
    """Ask for a move from the posture that is commanded, amid what is believed.

    Args:
        toolbox: Knows both, and deals the seed.
        joints, keep_others, pelvis_m, level: As for ``MoveRequest``.
    """
    return MoveRequest(
        q_start=toolbox.motion.reference(),
        stance=toolbox.motion.stance(),
        scene=toolbox.world.scene,
        joints=joints or {},
        keep_others=keep_others,
        pelvis_m=pelvis_m,
        level=level,
        seed=int(toolbox.rng.integers(2**31)),
    )
