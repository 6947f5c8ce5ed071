"""One episode of a skill: a room, tasks, and the truth about how the last one ended."""

from __future__ import annotations

import math
from dataclasses import replace

from executive.embedding.requests import Requests
from executive.errands.errand import Errand
from executive.runs.run import frozen_heap
from executive.session.assembly import assemble
from executive.session.driver import driven
from executive.session.events import PlanningAnswered
from executive.session.planning_jobs import PlanningJobs
from executive.session.session import Session
from executive.session.task_result import TaskResult, chain
from executive.trust import OnQuestion
from executive.understanding.spoken_in import spoken_in
from tools.evaluate.faults import FaultBench, FaultState
from tools.evaluate.orders import EpisodeOrder, body_for
from tools.evaluate.phases import PhaseWatch
from tools.evaluate.records import EpisodeRecord, broken_episode
from tools.evaluate.scenes import episode_rng, seen_by
from tools.evaluate.skills.faults import SKILL_FAULTS
from tools.evaluate.skills.registry import SKILL_SUITES
from tools.evaluate.skills.suite import ANY_END, SkillJudge, Trial, Verdict
from tools.evaluate.skills.watch import SafetyWatch


class PlanningWatch:
    """Put its ``take`` into the session's sink; what is counted is processor time.

    Attributes:
        requests_ms: Of each request since the last ``begin``.
    """

    def __init__(self, planning: PlanningJobs) -> None:
        self._planning = planning
        self._before_s = planning.cpu_s
        self.requests_ms: list[float] = []

    def begin(self) -> None:
        """Count from now on."""
        self.requests_ms.clear()

    def take(self, event: object) -> None:
        """Take one event of any kind: a request is answered before its event is sent."""
        if isinstance(event, PlanningAnswered):
            now_s = self._planning.cpu_s
            self.requests_ms.append(1e3 * (now_s - self._before_s))
            self._before_s = now_s


AFTER_S = 0.5
IN_PART = "told in part"
"""The outcome of an answer that said that there may be more, and was not right."""


def trial_of(suite: str, seed: int, scene: str | None = None, robot: str = "talos") -> Trial:
    """The episode of a seed.

    Args:
        suite: Of a skill.
        seed: The episode's.
        scene: "bench" for what an arm that is bolted down has before it, "low_tabletop" for a humanoid of a
            child's size; None for a room.
        robot: Whose hands are to take what is asked for.

    Raises:
        ValueError: The suite has no such episodes.
    """
    make = SKILL_SUITES[suite].makes(scene, robot)
    if make is None:
        raise ValueError(f"the suite {suite} has no episodes in the scene {scene!r}")
    return make(episode_rng(seed, 10))


def run_skill_episode(suite: str, order: EpisodeOrder) -> EpisodeRecord:
    """Run one episode; whatever breaks becomes its record."""
    try:
        return _run(suite, order)
    except Exception as broken:
        return broken_episode(order, broken)


def _run(suite: str, order: EpisodeOrder) -> EpisodeRecord:
    trial = _seen_as_ordered(suite, order)
    judges: list[SkillJudge] = []
    phases, fault = PhaseWatch(), FaultState()

    def sink(event: object) -> None:
        phases.take(event)
        for judge in judges:
            judge.on_event(event)

    assembly = assemble(order.robot, trial.scene, order.seed, sink=sink, drawn=False, body=body_for(order))
    judge = SKILL_SUITES[suite].judge(assembly, trial, episode_rng(order.seed, 11))
    judges.append(judge)
    hands = assembly.model.description.grippers.values()
    fingers = [link for gripper in hands for link in gripper.touch_links]
    watch = SafetyWatch(assembly.world.truth, lambda: assembly.loop.walking.active, fingers, trial.opened)
    assembly.session.watch_periods(judge.on_period)
    assembly.session.watch_periods(watch.on_period)
    if order.fault is not None:
        world, rng = assembly.world, episode_rng(order.seed, 12)
        SKILL_FAULTS[order.fault](
            FaultBench(trial.aim, trial.scene, world.truth, world.faults, assembly.perception, phases, rng),
            fault,
        )
    planning = PlanningWatch(assembly.planning)
    with frozen_heap():
        results, prepared = _asked(suite, assembly.session, trial, planning)
        assembly.session.hold(AFTER_S)
    verdict = judge.verdict(results)
    last = results[-1]
    links = chain(last.failure)
    told = " ← ".join(f"{link.where}: {link.message}" if link.where else link.message for link in links)
    if not prepared:
        told = f"while preparing with {last.text!r}: {told}"
    moving_wall_s = last.times.wall_s - last.times.planning_wall_s
    return EpisodeRecord(
        seed=order.seed,
        outcome=outcome_of(suite, last.outcome, verdict) if prepared else "failed",
        truth=prepared and verdict.done and not watch.fell,
        failure_kind=links[-1].kind.value if links else None,
        failure=told or verdict.why or None,
        attempts=last.attempts,
        fault=order.fault,
        fault_fired=fault.fired,
        fell=watch.fell,
        furniture_contacts=tuple(sorted(watch.contacts)),
        com_margin_m=watch.com_margin_m if SKILL_SUITES[suite].stands else math.inf,
        planning_ms=sum(planning.requests_ms) / max(last.attempts, 1),
        simulated_s=last.times.simulated_s,
        wall_s=last.times.wall_s,
        realtime_factor=last.times.simulated_s / moving_wall_s if moving_wall_s > 0.0 else 0.0,
        numbers={**verdict.numbers, "slowest_plan_ms": round(max(planning.requests_ms, default=0.0), 1)},
    )


def _seen_as_ordered(suite: str, order: EpisodeOrder) -> Trial:
    """The episode with the perception that is asked for; a camera does not see what people are called."""
    trial, unnamed = trial_of(suite, order.seed, order.scene, order.robot), SKILL_SUITES[suite].unnamed
    if order.perception == "rgbd" and unnamed is not None:
        trial = unnamed(trial)
    return replace(trial, scene=seen_by(trial.scene, order.perception))


def _asked(
    suite: str, session: Session, trial: Trial, planning: PlanningWatch
) -> tuple[list[TaskResult], bool]:
    """How the tasks ended, and whether all came to the last one; ``planning`` counted for that alone."""
    results: list[TaskResult] = []
    if trial.as_errand:
        planning.begin()
        with session.events.heard_by(planning.take):
            results += driven(Errand(session, trial.tasks, on_question="first").steps())
        return results, True
    for task in trial.first if trial.sentence else trial.tasks:
        planning.begin()
        with session.events.heard_by(planning.take):
            results.append(session.run_task(task))
        if results[-1].outcome != "done":
            break
    prepared = all(result.outcome == "done" for result in results)
    if trial.sentence and prepared:
        planning.begin()
        asks: OnQuestion = "fail" if SKILL_SUITES[suite].ends == ANY_END else "first"
        with (
            session.events.heard_by(planning.take),
            spoken_in(trial.scene),
        ):
            results += Requests(session).submit(trial.sentence, on_question=asks).result()
    elif not trial.sentence:
        prepared = len(results) == len(trial.tasks)
    return results, prepared


def outcome_of(suite: str, said: str, verdict: Verdict) -> str:
    """What the suite calls the end that the executive told: "done", or the executive's word.

    Args:
        suite: Name of the suite.
        said: The executive's word.
        verdict: What the truth says.
    """
    ends = SKILL_SUITES[suite].ends
    if ends == ANY_END:
        return "done" if verdict.done else said
    if verdict.reserved and not verdict.done and said == "done":
        return IN_PART
    return said if ends == "done" else "done" if said in (ends, "failed") else "failed"
