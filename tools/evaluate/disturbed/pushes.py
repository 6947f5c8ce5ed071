"""Suite of pushes: for a tenth of a second, from any side, at any instant, standing and walking."""

from __future__ import annotations

import math
import time
import traceback
from dataclasses import dataclass

from tools.evaluate.disturbed.bare_walk import BareWalk
from tools.evaluate.orders import EpisodeOrder
from tools.evaluate.records import Bar, EpisodeRecord, Summary
from tools.evaluate.scenes import episode_rng

STANDING_N = 250.0
FORWARD_N, SIDEWAYS_N = 200.0, 120.0
"""What has to be survived; forward and backward directions are those within 45 degrees."""
SHARES = (1.0, 1.0, 1.0, 1.25, 1.5, 1.75, 2.0)
"""Of that force; drawn with equal chances, so that three of seven pushes count for the demand."""
SURVIVED = 0.95
TORSO_EVERY = 4
"""One push of so many is at the torso instead of the pelvis; those are reported, and demanded is nothing."""
SPEED_M_S = (-0.3, 0.5)
PELVIS, TORSO = "base_link", "torso_2_link"
_AFTER_S = 2.5


def run_push_episode(order: EpisodeOrder) -> EpisodeRecord:
    """Run one episode; whatever breaks becomes its record."""
    try:
        return _run(order)
    except Exception as broken:
        return EpisodeRecord(
            order.seed,
            "error",
            truth=False,
            failure_kind="ERROR",
            failure=f"{type(broken).__name__}: {broken}",
            detail=traceback.format_exc(),
        )


def _run(order: EpisodeOrder) -> EpisodeRecord:
    began = time.process_time()
    rng = episode_rng(order.seed, 20)
    walking = bool(rng.random() < 0.6)
    angle = float(rng.uniform(-math.pi, math.pi))
    share = SHARES[int(rng.integers(len(SHARES)))]
    link = TORSO if rng.integers(TORSO_EVERY) == 0 else PELVIS
    at_s = float(rng.uniform(0.0, 1.24))
    speed = float(rng.uniform(*SPEED_M_S))
    sideways = abs(math.sin(angle)) > math.sqrt(0.5)
    bar_n = STANDING_N if not walking else SIDEWAYS_N if sideways else FORWARD_N
    body = BareWalk(order.robot, order.seed)
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
        "at": "torso" if link == TORSO else "pelvis",
        "force_n": share * bar_n,
        "share": share,
        "angle_deg": math.degrees(angle),
        "speed_m_s": speed if walking else 0.0,
        "at_s": at_s,
        "cpu_s": time.process_time() - began,
    }
    told = f"fell under {share * bar_n:.0f} N from {math.degrees(angle):.0f} degrees, {numbers['gait']}"
    return EpisodeRecord(
        order.seed,
        "done" if stands else "failed",
        truth=stands,
        failure_kind=None if stands else "EXECUTION",
        failure=None if stands else told,
        fell=not stands,
        simulated_s=simulated_s,
        numbers=numbers,
    )


@dataclass(frozen=True, slots=True)
class PushSummary(Summary):
    """The demands on pushes at the pelvis with the forces that are demanded."""

    def bars(self) -> list[Bar]:
        """Survived, by gait and side."""
        found = []
        for gait, side, force_n in (
            ("standing", None, STANDING_N),
            ("walking", "ahead or back", FORWARD_N),
            ("walking", "sideways", SIDEWAYS_N),
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
            name = f"{gait}{'' if side is None else ', ' + side}, {force_n:.0f} N"
            met = bool(counted) and stood >= SURVIVED * len(counted)
            found.append(Bar(name, f"{stood} of {len(counted)}", f"≥ {SURVIVED:.0%}", met))
        errors = sum(record.outcome == "error" for record in self.records)
        found.append(Bar("broken episodes", str(errors), "0", errors == 0))
        return found
