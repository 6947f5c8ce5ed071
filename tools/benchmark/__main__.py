"""``python -m tools.benchmark SUITE [--quick] [--json FILE]``."""

from __future__ import annotations

import argparse
import json
import os
import sys
from collections.abc import Sequence
from pathlib import Path

from rich.console import Console

SUITES = ("planning", "control")


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one suite on one core."""
    parser = argparse.ArgumentParser(prog="python -m tools.benchmark", description="How fast the parts are.")
    parser.add_argument("suite", choices=SUITES)
    parser.add_argument("--quick", action="store_true", help="fewer samples, under a minute")
    parser.add_argument("--json", type=Path, metavar="FILE")
    options = parser.parse_args(arguments)
    os.environ.update(OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")
    # after the number of threads is set: numerical libraries read it when they are loaded
    from tools.benchmark.control import control
    from tools.benchmark.figures import print_figures
    from tools.benchmark.planning import planning

    figures = {"planning": planning, "control": control}[options.suite](options.quick)
    print_figures(options.suite, figures, Console())
    if options.json is not None:
        document = {"suite": options.suite, "quick": options.quick, "figures": [f.to_json() for f in figures]}
        options.json.write_text(json.dumps(document, indent=1) + "\n", "utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
