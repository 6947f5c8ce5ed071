"""One episode: a door or drawer, a task, and the truth about how it ended."""

from __future__ import annotations

import math
import traceback
from dataclasses import dataclass

from executive.session.assembly import assemble
from executive.session.task_result import TaskResult, chain
from robots.errors import SceneError
from robots.simulated.truth.truth import SimulatorTruth
from tools.evaluate.opening.faults import OPENING_FAULTS, OpeningBench
from tools.evaluate.opening.judge import OpeningJudge
from tools.evaluate.opening.records import OpeningRecord
from tools.evaluate.opening.scenes import FURNITURE, OpeningScene, opening_scene
from tools.evaluate.phases import PhaseWatch
from tools.evaluate.scenes import episode_rng, seen_by
from trees.events import Measured
from trees.tasks import CloseTask, ObjectDescription, OpenTask

_HELD_S = 1.0
_DRAWS = 20


@dataclass(frozen=True, slots=True)
class OpeningOrder:
    """Which episode to run, how the robot sees in it (None: as the scene says), and before what."""

    suite: str
    seed: int
    robot: str
    fault: str | None = None
    perception: str | None = None
    where: str | None = None


def run_openings(order: OpeningOrder) -> list[OpeningRecord]:
    """Run one episode, for suites."""
    return [run_opening(order)]


def run_opening(order: OpeningOrder) -> OpeningRecord:
    """Run one episode; whatever breaks becomes its record.

    A door that stands open where the robot's hand is cannot be: it is drawn again.
    """
    for draw in range(_DRAWS):
        scene = opening_scene(order.seed, order.suite, draw, order.where)
        try:
            return _run(order, scene)
        except SceneError:
            continue
        except Exception:
            return _broken(order, scene, traceback.format_exc())
    return _broken(order, scene, f"no scene could be drawn in {_DRAWS} times")


def died(order: OpeningOrder) -> list[OpeningRecord]:
    """The record of an episode whose process died."""
    return [_broken(order, opening_scene(order.seed, order.suite, where=order.where), "the process died")]


def _broken(order: OpeningOrder, scene: OpeningScene, why: str) -> OpeningRecord:
    return OpeningRecord(order.seed, order.suite, scene.kind, scene.hinge, scene.locked, "error", detail=why)


def _run(order: OpeningOrder, scene: OpeningScene) -> OpeningRecord:
    felt: list[float] = []
    phases = PhaseWatch()

    def listen(event: object) -> None:
        phases.take(event)
        if isinstance(event, Measured) and "peak_force_n" in event.numbers:
            felt.append(float(event.numbers["peak_force_n"]))

    described = seen_by(scene.read(), order.perception)
    assembly = assemble(order.robot, described, order.seed, sink=listen, drawn=False)
    truth: SimulatorTruth = assembly.world.truth
    grippers = assembly.model.description.grippers.values()
    hands = frozenset(link for gripper in grippers for link in gripper.touch_links)
    pushing = hands if order.suite == "close" and scene.kind == "door" else frozenset()
    judge = OpeningJudge(truth, assembly.model.description.soles, FURNITURE, pushing)
    faults = assembly.perception.faults
    if described.perception.kind == "stub":  # a camera errs by itself
        for stub in (faults, *(other.faults for other in assembly.perception.cameras)):
            stub.misplace("handle", scene.handle_error_m, first_look_only=False)
            stub.misplace(scene.kind, scene.panel_error_m, first_look_only=False)
    fired: list[float] = []
    if order.fault is not None:
        rng = episode_rng(order.seed, 17)
        bench = OpeningBench(scene, truth, assembly.world.faults, faults, phases, rng, fired)
        OPENING_FAULTS[order.fault](bench)
    session = assembly.session
    session.watch_periods(judge.on_period)
    noun = ObjectDescription(kind="fridge" if scene.kind == "door" else "drawer")
    command = OpenTask("open it", noun) if order.suite == "open" else CloseTask("close it", noun)
    result = session.run_task(command)
    session.hold(_HELD_S)
    return _record(order, scene, judge, result, max(felt, default=0.0), bool(fired))


def _record(
    order: OpeningOrder,
    scene: OpeningScene,
    judge: OpeningJudge,
    result: TaskResult,
    felt_n: float,
    fault_fired: bool,
) -> OpeningRecord:
    door = scene.kind == "door"
    unit = "deg" if door else "m"
    links = chain(result.failure)
    told = " ← ".join(f"{link.where}: {link.message}" for link in links)
    claim, felt = result.evidence.get(f"opening_{unit}"), result.evidence.get(f"felt_{unit}")
    return OpeningRecord(
        seed=order.seed,
        suite=order.suite,
        kind=scene.kind,
        hinge=scene.hinge,
        locked=scene.locked,
        outcome=result.outcome,
        failure=told or None,
        failure_kind=links[-1].kind.value if links else None,
        stuck="is stuck" in told,
        attempts=result.attempts,
        opening=math.degrees(judge.opening) if door else judge.opening,
        claimed=None if claim is None else float(claim),
        felt=None if felt is None else float(felt),
        felt_n=felt_n,
        fault_fired=fault_fired,
        peak_n=judge.peak_force_n,
        feet_slip_m=judge.feet_slip_m,
        com_margin_m=judge.com_margin_m,
        fell=judge.fell,
        touched=tuple(sorted(judge.touched)),
        simulated_s=result.times.simulated_s,
        wall_s=result.times.wall_s,
        planning_ms=1e3 * result.times.planning_wall_s / max(result.attempts, 1),
    )
