"""Suite of pushes: for a tenth of a second, from any side, at any instant, standing and walking."""

from __future__ import annotations

import math
import time
from dataclasses import dataclass
from types import MappingProxyType

from tools.evaluate.disturbed.bare_walk import BareWalk
from tools.evaluate.orders import EpisodeOrder
from tools.evaluate.records import Bar, EpisodeRecord, Summary, broken_episode
from tools.evaluate.scenes import episode_rng


@dataclass(frozen=True, slots=True)
class Demanded:
    """What a robot has to survive, N; forward and backward directions are those within 45 degrees."""

    standing: float
    forward: float
    sideways: float

    def of(self, walking: bool, sideways: bool) -> float:
        """Of one push."""
        if not walking:
            return self.standing
        return self.sideways if sideways else self.forward


_GROWN_UP = Demanded(250.0, 200.0, 120.0)
DEMANDED = MappingProxyType({"talos": _GROWN_UP, "g1": Demanded(60.0, 40.0, 40.0)})
SHARES = (1.0, 1.0, 1.0, 1.25, 1.5, 1.75, 2.0)
"""Of that force; drawn with equal chances, so that three of seven pushes count for the demand."""
SURVIVED = 0.95
TORSO_EVERY = 4
"""One push of so many is at the torso instead of the pelvis; those are reported, and demanded is nothing."""
SPEED_M_S = (-0.3, 0.5)
_AFTER_S = 2.5


def run_push_episode(order: EpisodeOrder) -> EpisodeRecord:
    """Run one episode; whatever breaks becomes its record."""
    try:
        return _run(order)
    except Exception as broken:
        return broken_episode(order, broken)


def _run(order: EpisodeOrder) -> EpisodeRecord:
    began = time.process_time()
    rng = episode_rng(order.seed, 20)
    walking = bool(rng.random() < 0.6)
    angle = float(rng.uniform(-math.pi, math.pi))
    share = SHARES[int(rng.integers(len(SHARES)))]
    at_torso = rng.integers(TORSO_EVERY) == 0
    at_s = float(rng.uniform(0.0, 1.24))
    speed = float(rng.uniform(*SPEED_M_S))
    sideways = abs(math.sin(angle)) > math.sqrt(0.5)
    bar_n = DEMANDED.get(order.robot, _GROWN_UP).of(walking, sideways)
    body = BareWalk(order.robot, order.seed)
    link = body.torso if at_torso else body.world.robot.description.base_link
    stands = body.go_on(0.4)
    handle = None
    if walking:
        handle = body.set_out(speed, 0.0)
        stands = stands and body.go_on(2.0)
    stands = stands and body.go_on(at_s) and body.push(share * bar_n, angle, link) and body.go_on(_AFTER_S)
    if stands and handle is not None:
        stands = body.stands_again(handle)
    simulated_s = body.world.truth.time_s
    numbers = {
        "gait": "walking" if walking else "standing",
        "side": "sideways" if sideways else "ahead or back",
        "at": "torso" if at_torso else "pelvis",
        "force_n": share * bar_n,
        "share": share,
        "angle_deg": math.degrees(angle),
        "speed_m_s": speed if walking else 0.0,
        "at_s": at_s,
        "cpu_s": time.process_time() - began,
    }
    fell = body.world.truth.fallen()
    how = "fell" if fell else "did not come to rest"
    told = f"{how} under {share * bar_n:.0f} N from {math.degrees(angle):.0f} degrees, {numbers['gait']}"
    return EpisodeRecord(
        order.seed,
        "done" if stands else "failed",
        truth=stands,
        failure_kind=None if stands else "EXECUTION",
        failure=None if stands else told,
        fell=fell,
        simulated_s=simulated_s,
        numbers=numbers,
    )


@dataclass(frozen=True, slots=True)
class PushSummary(Summary):
    """The demands on pushes at the pelvis with the forces that are demanded."""

    def bars(self) -> list[Bar]:
        """Survived, by gait and side."""
        found = []
        for gait, side, usual_n in (
            ("standing", None, _GROWN_UP.standing),
            ("walking", "ahead or back", _GROWN_UP.forward),
            ("walking", "sideways", _GROWN_UP.sideways),
        ):
            counted = [
                record
                for record in self.records
                if record.numbers.get("gait") == gait
                and record.numbers.get("at") == "pelvis"
                and record.numbers.get("share") == 1.0
                and side in (None, record.numbers.get("side"))
            ]
            stood = sum(record.truth for record in counted)
            force_n = max((float(record.numbers["force_n"]) for record in counted), default=usual_n)
            name = f"{gait}{'' if side is None else ', ' + side}, {force_n:.0f} N"
            met = bool(counted) and stood >= SURVIVED * len(counted)
            found.append(Bar(name, f"{stood} of {len(counted)}", f"≥ {SURVIVED:.0%}", met))
        errors = sum(record.outcome == "error" for record in self.records)
        found.append(Bar("broken episodes", str(errors), "0", errors == 0))
        return found
