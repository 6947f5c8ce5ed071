"""What goes wrong at a door or drawer: it is seen at a wrong place, or somebody moves it during the reach."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from types import MappingProxyType

import numpy as np

from robots.perception.stub_faults import StubFaults
from robots.simulated.faults.world_faults import FaultInjector
from robots.simulated.truth.truth import SimulatorTruth
from tools.evaluate.opening.scenes import FURNITURE, OpeningScene
from tools.evaluate.phases import PhaseWatch

WRONG_BY_M = 0.04
MOVED_RAD, MOVED_M = (math.radians(8.0), math.radians(20.0)), (0.03, 0.10)
_REACH = "stream reach"
_LATER_S = (0.1, 0.9)


@dataclass(frozen=True, slots=True)
class OpeningBench:
    """What a fault may touch in one episode; ``fired`` holds when it happened, s."""

    scene: OpeningScene
    truth: SimulatorTruth
    injector: FaultInjector
    perception: StubFaults
    phases: PhaseWatch
    rng: np.random.Generator
    fired: list[float] = field(default_factory=list)


def _wrong_detection(bench: OpeningBench) -> None:
    """The first look tells handle and front 4 cm beside where later looks tell them."""
    heading = float(bench.rng.uniform(-math.pi, math.pi))
    off = np.array([WRONG_BY_M * math.cos(heading), WRONG_BY_M * math.sin(heading), 0.0])
    errors = (("handle", bench.scene.handle_error_m), (bench.scene.kind, bench.scene.panel_error_m))
    for kind, error in errors:
        x, y, z = (float(value) for value in off + error)
        bench.perception.misplace(kind, (x, y, z))
    bench.fired.append(bench.truth.time_s)


def _moved(bench: OpeningBench) -> None:
    """Somebody opens it somewhat while the hand is on its way, or closes what was wide open."""
    low, high = MOVED_RAD if bench.scene.kind == "door" else MOVED_M
    by, later_s = float(bench.rng.uniform(low, high)), float(bench.rng.uniform(*_LATER_S))

    def due() -> bool:
        began_s = bench.phases.began_s(_REACH)
        return began_s is not None and bench.truth.time_s >= began_s + later_s

    def act() -> None:
        bench.fired.append(bench.truth.time_s)
        opening = bench.truth.opening(FURNITURE)
        bench.injector.set_opening(FURNITURE, opening - by if opening > high else opening + by)

    if not bench.scene.locked:
        bench.injector.when(due, act)


OPENING_FAULTS: Mapping[str, Callable[[OpeningBench], None]] = MappingProxyType(
    {"moved": _moved, "wrong_detection": _wrong_detection}
)
"""By name."""
