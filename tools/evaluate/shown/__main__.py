"""``python -m tools.evaluate.shown --scenes 100 --seed 0``."""

from __future__ import annotations

import argparse
import sys

from robots.models.description import load_robot
from tools.evaluate.shown.judge import run, told

LEAST_RIGHT, MOST_WRONG = 0.90, 0.01


def main() -> int:
    """Judge some tables; 0 when the bars are met."""
    parser = argparse.ArgumentParser(prog="python -m tools.evaluate.shown", description=__doc__)
    parser.add_argument("--scenes", type=int, default=100)
    parser.add_argument("--seed", type=int, default=0)
    options = parser.parse_args()
    shares = told(run(load_robot("talos"), options.scenes, options.seed))
    for name, value in shares.items():
        print(f"{name}: {value:.3f}")
    return 0 if shares["right"] >= LEAST_RIGHT and shares["wrong"] <= MOST_WRONG else 1


if __name__ == "__main__":
    sys.exit(main())
