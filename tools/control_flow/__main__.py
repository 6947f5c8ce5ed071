"""``python -m tools.control_flow [--trees 500] FILE``: record what BehaviorTree.CPP does with random trees.

Needs its Python wheel ``behaviortreepy``, which ``make setup`` installs where there is one.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Sequence
from pathlib import Path

from tools.control_flow.random_trees import random_tree
from tools.control_flow.referee import WHEEL, referee_trace


def main(arguments: Sequence[str] | None = None) -> int:
    """Write the record; 2 when the wheel is not installed."""
    parser = argparse.ArgumentParser(prog="python -m tools.control_flow", description=__doc__)
    parser.add_argument("file", type=Path, help="where to write the record")
    parser.add_argument("--trees", type=int, default=500)
    options = parser.parse_args(arguments)
    try:
        traces = ["|".join(referee_trace(random_tree(seed))) for seed in range(options.trees)]
    except ModuleNotFoundError:
        print(f"error: the wheel {WHEEL} is not installed: pip install {WHEEL}", file=sys.stderr)
        return 2
    options.file.write_text(json.dumps(traces, indent=0) + "\n", "utf-8")
    print(f"{len(traces)} trees recorded in {options.file}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
