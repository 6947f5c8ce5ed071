"""Leaves that ask the planner or the checker, and wait for the answer without blocking."""

from __future__ import annotations

from typing import Generic, TypeVar

from py_trees.common import Status

from kinematics.requests.request import Request
from kinematics.requests.step import NoPlan, PlannedStep
from trees.failures import Failure
from trees.nodes.leaf import DONE, RUNNING, Leaf
from trees.nodes.plan_failures import no_plan_failure
from trees.port_values import Step
from trees.toolbox import Job

Answer = TypeVar("Answer")
Plan = TypeVar("Plan")


class JobLeaf(Leaf, Generic[Answer]):
    """A leaf that asks a planner or the checker for one answer.

    It begins the job, asks at each tick whether the answer is there, and cancels the job when it is halted
    before.
    """

    _job: Job[Answer] | None = None
    _refused: Failure | None = None

    def job(self) -> Job[Answer] | Failure:
        """Ask, or say why there is nothing to ask."""
        raise NotImplementedError

    def accept(self, answer: Answer) -> Failure | None:
        """Write the answer to the output ports, or say why it is no good."""
        raise NotImplementedError

    def begin(self) -> None:
        """Begin the job."""
        self._job = self._refused = None
        job = self.job()
        if isinstance(job, Failure):
            self._refused = job
        else:
            self._job = job

    def step(self) -> Status | Failure:
        """Poll the job."""
        if self._refused is not None:
            return self._refused
        if self._job is None:
            raise RuntimeError(f"{self.name} was ticked before it began")
        if not self._job.done:
            return RUNNING
        return self.accept(self._job.result()) or DONE

    def release(self, reason: str) -> None:
        """Forget the job."""
        self.feedback_message = reason
        if self._job is not None:
            self._job.cancel()


class PlanningLeaf(JobLeaf[Plan | NoPlan], Generic[Plan]):
    """Asks the planner from where the robot is, and writes the steps of its plan to ports."""

    _world_version: int = 0

    def request(self) -> Request[Plan | NoPlan] | Failure:
        """What to ask, or why there is nothing to ask."""
        raise NotImplementedError

    def planned(self, plan: Plan) -> None:
        """Write the plan to the output ports."""
        raise NotImplementedError

    def job(self) -> Job[Plan | NoPlan] | Failure:
        """Submit the request, for the scene as it is now."""
        self._world_version = self.toolbox.world.scene.version
        request = self.request()
        return request if isinstance(request, Failure) else self.toolbox.planning.submit(request)

    def accept(self, answer: Plan | NoPlan) -> Failure | None:
        """Take the plan; that there is none is a failure."""
        if isinstance(answer, NoPlan):
            return no_plan_failure(answer)
        self.planned(answer)
        return None

    def write_step(self, port: str, step: PlannedStep) -> None:
        """Write a step to a port, with the scene's version that it was planned for."""
        self._set_output(port, Step.of(step, self._world_version))
