"""What is planted: senses that do not agree, or a world that is another one after the look."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping

from kinematics.geometry.shapes import Cylinder
from tools.evaluate.faults import FAULTS, REACH, FaultBench, FaultState

BIASED_M = (0.020, 0.040)
TABLE_OFF_M = (0.008, 0.015)
TURNED_RAD = math.radians(2.0)
WRONG_SIZE = (2.0 / 3.0, 4.0 / 3.0)
WHOLLY_CHANCE = 0.5
"""Of a size that is wrong along all axes, and not only in width."""
_WIDEST_M = 0.085
"""A thing that seems wider is refused before a hand has felt anything."""

Plant = Callable[[FaultBench, FaultState], None]


def _kind(bench: FaultBench) -> str:
    return next(item.kind for item in bench.scene.objects if item.name == bench.target)


def _biased(bench: FaultBench, state: FaultState) -> None:
    """The camera shows the thing beside where it is, in every look."""
    heading, off_m = bench.rng.uniform(-math.pi, math.pi), bench.rng.uniform(*BIASED_M)
    offset = (float(off_m * math.cos(heading)), float(off_m * math.sin(heading)), 0.0)
    bench.perception.set_error(_kind(bench), offset, first_look_only=False)
    state.fired = True


def _table(bench: FaultBench, state: FaultState) -> None:
    """The camera shows the table too high or too low, and what stands on it where it is."""
    off_m = float(bench.rng.uniform(*TABLE_OFF_M)) * (1.0 if bench.rng.random() < 0.5 else -1.0)
    bench.perception.set_error(bench.scene.furniture[0].kind, (0.0, 0.0, off_m), first_look_only=False)
    state.fired = True


def _size(bench: FaultBench, state: FaultState) -> None:
    """The camera shows the thing a third too small or too large."""
    shape = next(item.shape for item in bench.scene.objects if item.name == bench.target)
    factors = list(WRONG_SIZE)
    if isinstance(shape, Cylinder) and 2.0 * shape.radius_m * WRONG_SIZE[1] > _WIDEST_M:
        factors.pop()
    factor = factors[int(bench.rng.integers(len(factors)))]
    wholly = bool(bench.rng.random() < WHOLLY_CHANCE)
    bench.perception.faults.resize(_kind(bench), (factor, factor, factor if wholly else 1.0))
    state.fired = True


def _miscalibrated(bench: FaultBench, state: FaultState) -> None:
    """The camera looks elsewhere than is believed: 2 degrees about an axis across its line of sight."""
    around = bench.rng.uniform(-math.pi, math.pi)
    turn = (TURNED_RAD * math.cos(around), TURNED_RAD * math.sin(around), 0.0)
    bench.perception.faults.turn_camera((float(turn[0]), float(turn[1]), 0.0))
    state.fired = True


def _gone(bench: FaultBench, state: FaultState) -> None:
    """Somebody takes the thing away during the reach."""
    delay_s = float(bench.rng.uniform(0.2, 1.2))

    def due() -> bool:
        began_s = bench.phases.began_s(REACH)
        return began_s is not None and bench.truth.time_s >= began_s + delay_s

    def act() -> None:
        bench.injector.remove(bench.target)
        state.fired = True

    bench.injector.when(due, act)


PLANTED: Mapping[str, Plant] = {
    "biased": _biased,
    "table": _table,
    "size": _size,
    "moved": FAULTS["moved"],
    "gone": _gone,
    "miscalibrated": _miscalibrated,
}
