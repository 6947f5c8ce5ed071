"""Which pairs of a robot's links need no judging: the list for a robot that comes without an SRDF.

    python -m tools.robot_data.disabled_collisions g1 > robots/models/g1/disabled_collisions.toml

As MoveIt's setup assistant does it: pairs that one joint separates, pairs that touch by design, and pairs
that are apart in every one of many random configurations. What is sampled is the whole range of the joints.
A pair counts as apart only when it was never nearer than a margin, which stands in for the configurations
that were not drawn; the list is a file to be read and corrected by a person.
"""

from __future__ import annotations

import argparse
from dataclasses import dataclass, replace

import numpy as np
import pinocchio as pin

from kinematics.model.robot_model import RobotModel
from robots.models.description import load_description

APART_M = 0.02
SAMPLES = 20_000
# Pairs that are nearer than planning allows in more of the configurations than this are built so.
PLANNING_M = 0.005
BY_DESIGN = 0.9
CLOSE = 3
"""Joints between the links of a pair that may be built into one another without touching always."""

Pair = tuple[str, str]


@dataclass(frozen=True, slots=True)
class DisabledPairs:
    """Pairs of links by the reason why they are not judged, each sorted."""

    adjacent: tuple[Pair, ...]
    by_design: tuple[Pair, ...]
    never: tuple[Pair, ...]


def find(model: RobotModel, samples: int, seed: int, close_share: float = BY_DESIGN) -> DisabledPairs:
    """Sort a robot's pairs of links.

    Args:
        model: The robot; pairs that its data disable already are not looked at.
        samples: Random configurations, over the whole range of every joint.
        seed: Of the configurations.
        close_share: Pairs with few joints between them that touch in more of the configurations than this
            count as built so. A chain of links whose hulls are fat takes less than the usual share.
    """
    geometry = model.geometry()
    pairs: dict[Pair, tuple[int, int]] = {}
    for pair in geometry.collisionPairs:
        parts = [geometry.geometryObjects[i] for i in (pair.first, pair.second)]
        first, second = sorted(model.link_of(part) for part in parts)
        pairs[first, second] = (int(parts[0].parentJoint), int(parts[1].parentJoint))
    adjacent = {pair for pair, bodies in pairs.items() if _adjacent(model, *bodies)}
    fewer = max(1, samples // 10)
    touching = _counts(model, geometry, PLANNING_M, fewer, seed)
    by_design = {
        pair
        for pair, count in touching.items()
        if count > (close_share if _between(model, *pairs[pair]) <= CLOSE else BY_DESIGN) * fewer
    } - adjacent
    near = _counts(model, geometry, APART_M, samples, seed)
    never = {pair for pair, count in near.items() if count == 0} - adjacent
    return DisabledPairs(tuple(sorted(adjacent)), tuple(sorted(by_design)), tuple(sorted(never)))


def _counts(
    model: RobotModel, geometry: pin.GeometryModel, margin_m: float, samples: int, seed: int
) -> dict[Pair, int]:
    """In how many random configurations each pair of links is nearer than a margin."""
    if not geometry.collisionPairs:
        return {}
    data, placed = model.pin.createData(), geometry.createData()
    for request in placed.collisionRequests:
        request.security_margin = margin_m
    rng = np.random.default_rng(seed)
    near = np.zeros(len(geometry.collisionPairs), dtype=np.intp)
    q = model.q_home.copy()
    for _ in range(samples):
        q[7:] = rng.uniform(model.lower_rad, model.upper_rad)
        pin.computeCollisions(model.pin, data, geometry, placed, q, False)
        near += [result.isCollision() for result in placed.collisionResults]
    counts: dict[Pair, int] = {}
    for pair, count in zip(geometry.collisionPairs, near, strict=True):
        first, second = sorted(model.link_of(geometry.geometryObjects[i]) for i in (pair.first, pair.second))
        # a link of several solids is as near as the nearest of them
        counts[first, second] = max(counts.get((first, second), 0), int(count))
    return counts


def _adjacent(model: RobotModel, first: int, second: int) -> bool:
    """Whether two bodies are the same or hang on one another."""
    parents = model.pin.parents
    return first == second or int(parents[first]) == second or int(parents[second]) == first


def _between(model: RobotModel, first: int, second: int) -> int:
    """How many joints are between two bodies; very many when they are on different branches."""
    low, high = sorted((first, second))
    for count in range(CLOSE + 1):
        if high == low:
            return count
        high = int(model.pin.parents[high])
    return CLOSE + 1


def pairs_text(found: DisabledPairs, robot: str, samples: int, seed: int) -> str:
    """The list as a file, with the command that made it."""
    lines = [
        "# Pairs of links that are not judged against each other. Made by",
        f"# python -m tools.robot_data.disabled_collisions {robot} --samples {samples} --seed {seed}",
    ]
    for key, why, pairs in (
        ("adjacent", "one body, or one joint between them", found.adjacent),
        ("by_design", f"nearer than {PLANNING_M} m nearly always: they are built so", found.by_design),
        ("never", f"in no random configuration nearer than {APART_M} m", found.never),
    ):
        lines += ["", f"# {why}", f"{key} = ["]
        lines += [f'    ["{first}", "{second}"],' for first, second in pairs]
        lines.append("]")
    return "\n".join(lines)


def main() -> None:
    """Print a robot's list."""
    parser = argparse.ArgumentParser(
        prog="tools.robot_data.disabled_collisions", description=__doc__.split("\n")[0]
    )
    parser.add_argument("robot")
    parser.add_argument("--samples", type=int, default=SAMPLES)
    parser.add_argument("--seed", type=int, default=0)
    chosen = parser.parse_args()
    description = replace(load_description(chosen.robot), disabled_collisions=frozenset())
    found = find(RobotModel(description), chosen.samples, chosen.seed)
    print(pairs_text(found, chosen.robot, chosen.samples, chosen.seed))


if __name__ == "__main__":
    main()
