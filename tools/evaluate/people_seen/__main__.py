"""``python -m tools.evaluate.people_seen --scenes 100 --seed 0``."""

from __future__ import annotations

import argparse
import sys

from robots.models.description import load_robot
from tools.evaluate.people_seen.judge import PersonRecord, judged, told

BARS = {"found": 0.95, "posture right": 0.90, "gesture right": 0.90, "clothes right of told": 0.85}


def main() -> int:
    """Judge some scenes; 0 when the bars are met."""
    parser = argparse.ArgumentParser(prog="python -m tools.evaluate.people_seen", description=__doc__)
    parser.add_argument("--scenes", type=int, default=100)
    parser.add_argument("--seed", type=int, default=0)
    options = parser.parse_args()
    robot = load_robot("talos")
    records: list[PersonRecord] = []
    for seed in range(options.seed, options.seed + options.scenes):
        records += judged(robot, seed)[0]
    shares = told(records)
    for name, value in shares.items():
        print(f"{name}: {value:.3f}")
    return 0 if all(shares[name] >= bar for name, bar in BARS.items()) else 1


if __name__ == "__main__":
    sys.exit(main())
