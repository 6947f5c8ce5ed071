"""Faults of an episode: what goes wrong, and in which phase of the pick."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from robots.scenes.scene_description import SceneDescription
from robots.simulated.eyes import SimulatedPerception
from robots.simulated.faults.world_faults import FaultInjector
from robots.simulated.truth.truth import SimulatorTruth
from tools.evaluate.phases import PhaseWatch
from tools.evaluate.scenes import CUP_AHEAD_M, CUP_ASIDE_M

# Names of the tree's leaves in which faults happen.
REACH = "stream reach"
CLOSE = "close gripper"
LIFT = "stream lift"
VERIFY = "verify lift"

MOVED_M = (0.03, 0.10)
KNOCKED_M = (0.02, 0.06)
# Share of the friction that would just carry the object.
SLIPPERY = (0.2, 0.95)
_LEAST_FRICTION = 0.005
_GRAVITY_M_S2 = 9.81
WRONG_BY_M = 0.04
TIPPED_SHARE = 1.0 / 3.0
# A displaced object keeps this from hands and other objects, so that it lands in nothing.
_CLEAR_HAND_M = 0.15
_CLEAR_OBJECT_M = 0.12
_EDGE_ROOM_M = 0.05
# A pushed object has come to rest by then, and stands when it leans by less than this.
_AT_REST_S = 1.0
_STANDING_RAD = 0.2


@dataclass(slots=True)
class FaultState:
    """Whether an episode's fault happened, and whether it can be recovered from."""

    fired: bool = False
    recoverable: bool = False


@dataclass(frozen=True, slots=True)
class FaultBench:
    """What a fault may touch in one episode."""

    target: str
    scene: SceneDescription
    truth: SimulatorTruth
    injector: FaultInjector
    perception: SimulatedPerception
    phases: PhaseWatch
    rng: np.random.Generator


Arm = Callable[[FaultBench, FaultState], None]


def _empty_grasp(bench: FaultBench, state: FaultState) -> None:
    """The object is gone just before the fingers close."""
    _in_phase(bench, state, (CLOSE,), 0.0, lambda: bench.injector.remove(bench.target))


def _slip(bench: FaultBench, state: FaultState) -> None:
    """The object turns slippery while it is lifted: it slides out, fast or slowly."""
    slip_in(bench, state, (LIFT,))


def slip_in(bench: FaultBench, state: FaultState, phases: Sequence[str]) -> None:
    """The object turns slippery in one of some phases.

    The friction is a share of what the present grip would need, so that light objects slide too.
    """
    share, delay_s = float(bench.rng.uniform(*SLIPPERY)), float(bench.rng.uniform(0.0, 1.0))
    mass_kg = next(item.mass_kg for item in bench.scene.objects if item.name == bench.target)

    def act() -> None:
        normal_n = sum(contact.normal_n for contact in bench.truth.contacts.of_pads(bench.target))
        needed = mass_kg * _GRAVITY_M_S2 / max(normal_n, 1.0)
        bench.injector.set_pad_friction(bench.target, max(share * needed, _LEAST_FRICTION))

    _in_phase(bench, state, phases, delay_s, act)


def _moved(bench: FaultBench, state: FaultState) -> None:
    """Somebody puts the object elsewhere during the reach."""

    def act() -> None:
        offset, state.recoverable = _offset(bench, MOVED_M)
        bench.injector.displace(bench.target, (float(offset[0]), float(offset[1])))

    _in_phase(bench, state, (REACH,), float(bench.rng.uniform(0.2, 1.2)), act)


def _knocked(bench: FaultBench, state: FaultState) -> None:
    """Something pushes the object during the reach: it slides, or it falls over.

    A push that is meant to slide it topples a tall one, so that only its end tells what it was.
    """
    tips = bool(bench.rng.random() < TIPPED_SHARE)

    def act() -> None:
        offset, _ = _offset(bench, KNOCKED_M)
        heading = math.atan2(offset[1], offset[0])
        if tips:
            bench.injector.tip_over(bench.target, heading)
        else:
            bench.injector.knock(bench.target, heading, float(np.linalg.norm(offset)))
        bench.injector.at(bench.truth.time_s + _AT_REST_S, settle)

    def settle() -> None:
        stands = bench.truth.tilt_rad(bench.target) < _STANDING_RAD
        place = bench.truth.world_T_object(bench.target)[:2, 3]
        state.recoverable = stands and _promised(place)

    _in_phase(bench, state, (REACH,), float(bench.rng.uniform(0.2, 1.2)), act)


def _taken(bench: FaultBench, state: FaultState) -> None:
    """Somebody takes the object out of the hand after the lift."""
    take_in(bench, state, (VERIFY,), float(bench.rng.uniform(0.1, 1.5)))


def take_in(bench: FaultBench, state: FaultState, phases: Sequence[str], delay_s: float) -> None:
    """The object is gone some time after one of some phases began."""
    _in_phase(bench, state, phases, delay_s, lambda: bench.injector.remove(bench.target))


def _wrong_detection(bench: FaultBench, state: FaultState) -> None:
    """The first look tells a place 4 cm beside the true one."""
    heading = float(bench.rng.uniform(-math.pi, math.pi))
    kind = next(item.kind for item in bench.scene.objects if item.name == bench.target)
    bench.perception.set_error(kind, (WRONG_BY_M * math.cos(heading), WRONG_BY_M * math.sin(heading), 0.0))
    state.fired = state.recoverable = True


def _in_the_scene(_bench: FaultBench, state: FaultState) -> None:
    """The scene itself is the fault."""
    state.fired = True


FAULTS: dict[str, Arm] = {
    "empty_grasp": _empty_grasp,
    "slip": _slip,
    "moved": _moved,
    "knocked": _knocked,
    "taken": _taken,
    "wrong_detection": _wrong_detection,
    "nothing_there": _in_the_scene,
    "too_close": _in_the_scene,
}


def _in_phase(
    bench: FaultBench, state: FaultState, phases: Sequence[str], delay_s: float, act: Callable[[], None]
) -> None:
    """Act once, some time after a leaf of one of these names began."""

    def due() -> bool:
        began = [began_s for name in phases if (began_s := bench.phases.began_s(name)) is not None]
        return bool(began) and bench.truth.time_s >= min(began) + delay_s - 1e-9

    def fire() -> None:
        state.fired = True
        act()

    bench.injector.when(due, fire)


def _offset(bench: FaultBench, span_m: tuple[float, float]) -> tuple[NDArray[np.float64], bool]:
    """A step for the target that ends on the table, clear of hands and objects.

    Returns:
        The step in the world's x and y, and whether it ends where a pick is promised to work.
    """
    here = bench.truth.world_T_object(bench.target)[:3, 3]
    best = np.zeros(2)
    for _ in range(200):
        heading, length = bench.rng.uniform(-math.pi, math.pi), bench.rng.uniform(*span_m)
        step = length * np.array([math.cos(heading), math.sin(heading)])
        if not _free(bench, here[:2] + step, float(here[2])):
            continue
        if _promised(here[:2] + step):
            return step, True
        best = step
    if not best.any():
        best = np.array([span_m[0], 0.0])
    return best, False


def _promised(place: NDArray[np.float64]) -> bool:
    """Whether picks are promised to work there."""
    return bool(CUP_AHEAD_M[0] <= place[0] <= CUP_AHEAD_M[1] and abs(place[1]) <= CUP_ASIDE_M)


def _free(bench: FaultBench, place: NDArray[np.float64], height_m: float) -> bool:
    on_a_table = any(
        np.all(np.abs(place - table.position_m) <= 0.5 * np.array(table.size_m[:2]) - _EDGE_ROOM_M)
        for table in bench.scene.furniture
    )
    hands = [bench.truth.world_T_tcp(hand)[:3, 3] for hand in bench.truth.hands]
    others = [
        bench.truth.world_T_object(name)[:2, 3] for name in bench.truth.objects() if name != bench.target
    ]
    there = np.array([*place, height_m])
    return (
        on_a_table
        and all(float(np.linalg.norm(there - hand)) >= _CLEAR_HAND_M for hand in hands)
        and all(float(np.linalg.norm(place - other)) >= _CLEAR_OBJECT_M for other in others)
    )
