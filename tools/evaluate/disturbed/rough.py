"""Suite of walks with one thing wrong all the while: a sensor, the floor, the robot's mass."""

from __future__ import annotations

import math
import time
from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np

from robots.scenes.scene_description import Furniture
from tools.evaluate.disturbed.bare_walk import BareWalk
from tools.evaluate.orders import EpisodeOrder
from tools.evaluate.records import Bar, EpisodeRecord, Summary, broken_episode
from tools.evaluate.scenes import episode_rng

GYRO_RAD_S = math.radians(0.5)
ENCODER_RAD = math.radians(0.5)
FRICTION = 0.5
MASS_SHARE = 1.05
DELAY_PERIODS = 5
"""10 ms."""
UNEVEN_M = 0.01
WALK_S = 8.0
SURVIVED = 0.95
_PLATE_M = 0.25

WRONG: Mapping[str, str] = MappingProxyType(
    {
        "gyro": "gyro bias 0.5 deg/s, from the first step on",
        "encoder": "offset of a leg's encoder 0.5 deg, from the first step on",
        "slippery": "friction of the floor 0.5",
        "heavy": "mass + 5 %",
        "delay": "sensors 10 ms late",
        "uneven": "plates of up to 1 cm on the floor",
    }
)


def run_rough_episode(order: EpisodeOrder) -> EpisodeRecord:
    """Run one episode; what is wrong follows from its seed, in turn."""
    try:
        return _run(order)
    except Exception as broken:
        return broken_episode(order, broken)


def _run(order: EpisodeOrder) -> EpisodeRecord:
    began = time.process_time()
    rng = episode_rng(order.seed, 21)
    wrong = tuple(WRONG)[order.seed % len(WRONG)]
    linear, angular = float(rng.uniform(-0.3, 0.5)), float(rng.uniform(-0.5, 0.5))
    plates = scattered_plates(rng) if wrong == "uneven" else ()
    body = BareWalk(order.robot, order.seed, plates, DELAY_PERIODS if wrong == "delay" else 0)
    model = body.world.physics.model
    if wrong == "slippery":
        model.geom_friction[model.geom("floor").id, 0] = FRICTION
    elif wrong == "heavy":
        mine = _robot_bodies(body)
        model.body_mass[mine] *= MASS_SHARE
        model.body_inertia[mine] *= MASS_SHARE
    stands = body.go_on(0.4)
    handle = body.set_out(linear, angular)
    if wrong == "gyro":
        axis = rng.standard_normal(3)
        bias = GYRO_RAD_S * axis / float(np.linalg.norm(axis))
        body.world.body_faults.bias_gyro((float(bias[0]), float(bias[1]), float(bias[2])))
    elif wrong == "encoder":
        description = body.world.robot.description
        legs = [*description.groups["left_leg"], *description.groups["right_leg"]]
        sign = 1.0 if rng.random() < 0.5 else -1.0
        body.world.body_faults.offset_encoder(legs[int(rng.integers(len(legs)))], sign * ENCODER_RAD)
    stands = stands and body.go_on(WALK_S)
    walked = handle.status.value
    stands = stands and body.stands_again(handle)
    fell = body.world.truth.fallen()
    told = f"{'fell' if fell else 'did not come to rest'} with {WRONG[wrong]}"
    return EpisodeRecord(
        order.seed,
        "done" if stands else "failed",
        truth=stands,
        failure_kind=None if stands else "EXECUTION",
        failure=None if stands else told,
        fell=fell,
        simulated_s=body.world.truth.time_s,
        numbers={
            "wrong": wrong,
            "linear_m_s": linear,
            "angular_rad_s": angular,
            "after_walk": walked,
            "cpu_s": time.process_time() - began,
        },
    )


def _robot_bodies(body: BareWalk) -> list[int]:
    """Ids of the bodies that hang on the robot's base."""
    model, base = body.world.physics.model, body.world.physics.base_body
    return [k for k in range(model.nbody) if int(model.body_rootid[k]) == int(model.body_rootid[base])]


def scattered_plates(rng: np.random.Generator) -> tuple[Furniture, ...]:
    """Thin plates all around the start, but not under the feet."""
    plates = []
    for k in range(150):
        x, y = (float(value) for value in rng.uniform(-3.5, 3.5, 2))
        if math.hypot(x, y) < 0.45:
            continue
        size = (_PLATE_M, _PLATE_M, float(rng.uniform(0.002, UNEVEN_M)))
        plates.append(Furniture(f"plate {k}", "wall", size, (x, y), float(rng.uniform(-1.5, 1.5)), 0.8))
    return tuple(plates)


@dataclass(frozen=True, slots=True)
class RoughSummary(Summary):
    """The demands on walks with something wrong."""

    def bars(self) -> list[Bar]:
        """Survived, by what is wrong."""
        found = []
        for wrong, words in WRONG.items():
            counted = [record for record in self.records if record.numbers.get("wrong") == wrong]
            if counted:
                stood = sum(record.truth for record in counted)
                met = stood >= SURVIVED * len(counted)
                found.append(Bar(words, f"{stood} of {len(counted)}", f"≥ {SURVIVED:.0%}", met))
        errors = sum(record.outcome == "error" for record in self.records)
        found.append(Bar("broken episodes", str(errors), "0", errors == 0))
        return found
