"""The suite of first grasps: ``grips --scene FILE``, a hand without an arm, each thing of a scene in turn.

What the planner would try first of a thing that stands alone on a table is tried in physics, with the thing
5 mm and 3 degrees beside where it is thought to be. Where it slips, or nothing was found, the exhaustive
search is asked, and what that finds is tried as well: a thing counts if any grasp can hold it.
"""

from __future__ import annotations

import argparse
import itertools
import math
import traceback
from collections import Counter
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
from rich.console import Console

from kinematics.arrays import Array
from kinematics.geometry import poses
from kinematics.model.robot_description import GripperDescription
from kinematics.planning.grasps_of_shapes import no_grasp_reason
from robots.clock import ProcessorClock
from robots.models.description import load_description
from robots.scenes.scene_file import load_scene
from robots.simulated.floating_hand import holds
from tools.evaluate.harness.statistics import interval, share_text
from tools.evaluate.record_suite import run_record_suite
from tools.evaluate.records import Bar
from tools.evaluate.upon.hand_alone import ways_to_take
from tools.evaluate.upon.takeable import hands_of

GRIPS_SUITE = "grips"
HELD_BAR, RANKED_BAR_MS = 0.93, 150.0
_WRONG_M, _WRONG_RAD = 0.005, math.radians(3.0)
"""The exhaustive search leaves as much free on each side: with less the hand would come down on the thing."""
_TRIED = 40
"""Of what the exhaustive search finds, at most: a thing of which they all slip is none to be held."""
_SPREAD = 25
"""Every so manyth is tried: those that follow each other are alike."""


@dataclass(frozen=True, slots=True)
class GripOrder:
    """Which thing to try.

    Attributes:
        seed: Of how wrong its place is.
        index: Of the thing in the scene.
        scene: Name or file of the scene.
        robot: Whose hand.
    """

    seed: int
    index: int
    scene: str
    robot: str


@dataclass(frozen=True, slots=True)
class GripRecord:
    """What became of one thing.

    Attributes:
        seed: Of how wrong its place was.
        index: Of the thing in the scene.
        thing: Its name.
        found: Grasps that are ranked, with room for the hand.
        held: Whether the first of them lifted it.
        holdable: Whether any grasp of the exhaustive search did, asked where the first did not; else true.
        ranked_ms: Of processor time, from the cached table to ranked candidates.
        reason: Why there is no grasp, as a person is told.
        error: A traceback, when the evaluation broke.
    """

    seed: int
    index: int
    thing: str = ""
    found: int = 0
    held: bool = False
    holdable: bool = False
    ranked_ms: float = 0.0
    reason: str = ""
    error: str | None = None

    @property
    def faults(self) -> tuple[str, ...]:
        """Which demands it broke."""
        broken = {
            "broken": self.error is not None,
            "slipped": self.found > 0 and not self.held and self.holdable,
            "refused, and can be held": self.error is None and not self.found and self.holdable,
        }
        return tuple(name for name, is_so in broken.items() if is_so)


class GripSummary:
    """What all things say together."""

    def __init__(self, seed: int, records: Sequence[GripRecord]) -> None:
        self.seed, self.records = seed, records

    def bars(self) -> list[Bar]:
        """The demands."""
        can = [record for record in self.records if record.holdable]
        held = sum(record.held for record in can)
        reached = bool(can) and interval(held, len(can))[1] >= HELD_BAR
        slowest_ms = max((record.ranked_ms for record in self.records), default=0.0)
        broken = sum(record.error is not None for record in self.records)
        return [
            Bar(f"first grasp held, of {len(can)}", share_text(held, len(can)), f"≥ {HELD_BAR:.0%}", reached),
            Bar(
                "ranked, worst",
                f"{slowest_ms:.0f} ms",
                f"≤ {RANKED_BAR_MS:.0f} ms",
                slowest_ms <= RANKED_BAR_MS,
            ),
            Bar("broken", str(broken), "0", not broken),
        ]

    def figures(self) -> dict[str, float]:
        """Numbers worth knowing."""
        faults = Counter(name for record in self.records for name in record.faults)
        nothing = sum(not record.holdable and record.error is None for record in self.records)
        return {
            "things that no grasp holds": float(nothing),
            **{name: float(n) for name, n in faults.items()},
        }

    def to_json(self) -> dict[str, Any]:
        """The evaluation's document."""
        return {
            "suite": GRIPS_SUITE,
            "seed": self.seed,
            "bars": [asdict(bar) for bar in self.bars()],
            "figures": self.figures(),
            "records": [{**asdict(record), "faults": list(record.faults)} for record in self.records],
        }


def run_grips(options: argparse.Namespace, messages: Console) -> int:
    """Run the suite; 0 when every demand is met, 2 for a robot or a scene that it is not for."""
    description = load_description(options.robot)
    if description.grippers[description.gripping_hands[0]].palm_side_m is not None:
        messages.print(f"error: {options.robot} closes its fingers on a palm: no floating hand is like that")
        return 2
    if options.scene is None:
        messages.print(f"error: the suite {GRIPS_SUITE} needs a scene: --scene FILE", style="bold")
        return 2
    things = load_scene(options.scene).objects
    meshes = [index for index, item in enumerate(things) if item.shape.parts is not None]
    if not meshes:
        messages.print(f"error: {options.scene}: nothing in it has a mesh", style="bold", markup=False)
        return 2
    orders = [
        GripOrder(options.seed + i, meshes[i % len(meshes)], options.scene, options.robot)
        for i in range(options.episodes)
    ]

    def summarise(records: Sequence[GripRecord]) -> GripSummary:
        return GripSummary(options.seed, records)

    return run_record_suite(
        f"first grasps of {len(meshes)} things",
        orders,
        run_grip,
        _died,
        summarise,
        line=_line,
        place=lambda record: (record.seed,),
        execution=options.execution,
        document=options.json,
        messages=messages,
    )


def _died(order: GripOrder) -> list[GripRecord]:
    return [GripRecord(order.seed, order.index, error="its process died")]


def _line(record: GripRecord) -> str:
    said = f": {', '.join(record.faults).upper()}" if record.faults else ""
    how = "held" if record.held else "not held" if record.found else record.reason or "no grasp"
    return f"seed {record.seed} {record.thing}: {record.found} grasps, {how}{said} {record.error or ''}"


def run_grip(order: GripOrder) -> list[GripRecord]:
    """Try one thing; whatever breaks becomes its record."""
    try:
        return [_tried(order)]
    except Exception:
        return [GripRecord(order.seed, order.index, error=traceback.format_exc())]


def _tried(order: GripOrder) -> GripRecord:
    item, hands = load_scene(order.scene).objects[order.index], hands_of(order.robot)
    parts, hand = item.shape.parts, hands.model.description.gripping_hands[0]
    if parts is None:
        raise ValueError(f"{item.name} has no mesh: it is grasped by its outline")
    gripper = hands.model.description.grippers[hand]
    scene = hands.alone(item)
    there = scene.objects[item.name]
    hands.ranked(hand, scene, item.name)
    clock = ProcessorClock()
    began_s = clock.now_s()
    found = hands.ranked(hand, scene, item.name)
    ranked_ms = 1000.0 * (clock.now_s() - began_s)
    wrong = _wrong(np.random.default_rng(order.seed))

    def lifts(world_T_tcp: Array) -> bool:
        at = poses.inverse(there.world_T_object) @ world_T_tcp
        return holds(parts, at, gripper.max_opening_m, _pads(gripper), item.mass_kg)

    held = len(found) > 0 and lifts(found[0] @ wrong)
    # what follows each other is alike: the search is long, and not all of it is tried
    ways = ways_to_take(hands.model, hand, scene, item.name, _WRONG_M)
    some = itertools.islice(ways, 0, _TRIED * _SPREAD, _SPREAD)
    holdable = held or any(lifts(pose @ wrong) for pose in some)
    reason = "" if len(found) else no_grasp_reason(there, hands.model, hand) or ""
    return GripRecord(order.seed, order.index, item.name, len(found), held, holdable, ranked_ms, reason)


def _pads(gripper: GripperDescription) -> tuple[float, float]:
    """Half-sizes of its smallest pad: along the approach, across it."""
    half = np.array(gripper.pad_half_size_m)
    return float(half[:, 2].min()), float(half[:, 0].min())


def _wrong(rng: np.random.Generator) -> Array:
    turn, shift = rng.normal(size=3), rng.normal(size=3)
    rotation = poses.rotation_from_vector(_WRONG_RAD * turn / np.linalg.norm(turn))
    return poses.transform(rotation, _WRONG_M * shift / np.linalg.norm(shift))
