"""One pick, with or without a planted disagreement, and what was noticed of it."""

from __future__ import annotations

import math
import traceback
from dataclasses import dataclass, replace

from executive.runs.run import frozen_heap
from executive.session.assembly import assemble
from executive.session.task_result import chain
from executive.understanding.command_parser import parse
from robots.scenes.scene_description import PerceptionModel
from tools.evaluate.faults import FaultBench, FaultState
from tools.evaluate.fusion.planted import PLANTED
from tools.evaluate.fusion.record import FusionRecord
from tools.evaluate.judge import HELD_S, Judge
from tools.evaluate.phases import PhaseWatch
from tools.evaluate.scenes import TARGET, episode_rng, episode_scene, read_episode_scene, sentence_for
from trees.events import LeafFailed, NotSo
from trees.failures import DISAGREEMENTS, Failure

NO_PLANT = "none"
USUAL_M = PerceptionModel().bias_m
"""The declared error of a place along each axis, as usual."""
OWN_M = 0.002
"""The part of it that each thing has for itself; the rest is the calibration, which all things share.

Where all of it is each thing's own, a table that is 8 to 15 mm off is no disagreement: no test that raises
a false alarm in one of fifty picks tells half of them from what is usual, even if it knew the true height.
"""


@dataclass(frozen=True, slots=True)
class FusionOrder:
    """Which episode to run.

    Attributes:
        seed: Of scene, run and what is planted.
        planted: Whether anything is; which is drawn by the seed.
        own_m: Declared error of the stub that each thing has for itself; with what all have in common it is
            ``USUAL_M``.
    """

    seed: int
    planted: bool
    own_m: float = OWN_M
    robot: str = "talos"


def perception_of(own_m: float) -> PerceptionModel:
    """A stub whose declared error is the usual one, of which each thing has so much for itself."""
    common_m = math.sqrt(max(USUAL_M**2 - own_m**2, 0.0))
    return PerceptionModel(bias_m=own_m, calibration_m=common_m)


def run_fusion(order: FusionOrder) -> list[FusionRecord]:
    """Run one episode; whatever breaks becomes its record."""
    try:
        return [_run(order)]
    except Exception:
        return [FusionRecord(order.seed, _plant_of(order), error=traceback.format_exc())]


def died(order: FusionOrder) -> list[FusionRecord]:
    """The record of an episode whose process died."""
    return [FusionRecord(order.seed, _plant_of(order), error="the process died")]


def _plant_of(order: FusionOrder) -> str:
    names = tuple(PLANTED)
    draw = int(episode_rng(order.seed, 11).integers(len(names)))
    return names[draw] if order.planted else NO_PLANT


class _Watch:
    """Keeps which disagreements were told, each once."""

    def __init__(self) -> None:
        self.noticed: dict[str, str] = {}
        self.phases = PhaseWatch()

    def take(self, event: object) -> None:
        self.phases.take(event)
        if isinstance(event, LeafFailed | NotSo):
            link: Failure | None = event.failure
            while link is not None:
                if link.reason in DISAGREEMENTS:
                    self.noticed.setdefault(link.reason.name, link.message)
                link = link.cause


def _run(order: FusionOrder) -> FusionRecord:
    scene = read_episode_scene(episode_scene(order.seed), order.seed)
    scene = replace(scene, perception=perception_of(order.own_m))
    watch, plant = _Watch(), _plant_of(order)
    assembly = assemble(order.robot, scene, order.seed, sink=watch.take)
    truth, session, state = assembly.world.truth, assembly.session, FaultState()
    judge = Judge(truth, TARGET)
    session.watch_periods(judge.on_period)
    if order.planted:
        rng = episode_rng(order.seed, 12)
        injector, perception = assembly.world.faults, assembly.perception
        PLANTED[plant](FaultBench(TARGET, scene, truth, injector, perception, watch.phases, rng), state)
    (command,) = parse(sentence_for(scene)).commands
    with frozen_heap():
        result = session.run_task(command)
        judge.begin_hold()
        session.hold(HELD_S)
    links = chain(result.failure)
    return FusionRecord(
        seed=order.seed,
        planted=plant,
        fired=state.fired,
        noticed=tuple(watch.noticed),
        said=tuple(watch.noticed.values()),
        outcome=result.outcome,
        truth=judge.truly_held,
        told=bool(watch.noticed) or bool(links and links[0].message),
        attempts=result.attempts,
        fell=judge.fell,
        failure=" ← ".join(link.message for link in links),
    )
