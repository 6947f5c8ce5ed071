"""``python -m tools.benchmark SUITE [--quick] [--json FILE]``."""

from __future__ import annotations

import argparse
import json
import os
import shutil
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from rich.console import Console

if TYPE_CHECKING:
    from tools.benchmark.report import Report

SUITES = (
    "planning",
    "pick",
    "meshes",
    "arm",
    "ik",
    "collision",
    "timing",
    "checker",
    "tick",
    "control",
    "ros",
    "startup",
    "recording",
    "view",
    "eyes",
    "view_long",
    "many_cores",
)
_BROWSED = frozenset({"view", "view_long"})


class _ListSuites(argparse.Action):
    def __call__(self, parser: argparse.ArgumentParser, *_: object) -> None:
        without = set() if shutil.which("chromium") else _BROWSED
        print(*(suite for suite in SUITES if suite not in without))
        parser.exit()


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one suite on one core."""
    from tools.benchmark.peers.environments import CACHE_VARIABLE, default_cache

    parser = argparse.ArgumentParser(prog="python -m tools.benchmark", description="How fast the parts are.")
    parser.add_argument("suite", choices=SUITES)
    parser.add_argument(
        "--list", action=_ListSuites, nargs=0, help="print the names of the suites that this machine can run"
    )
    parser.add_argument("--quick", action="store_true", help="fewer samples, under a minute")
    parser.add_argument("--json", type=Path, metavar="FILE")
    parser.add_argument(
        "--cache", type=Path, default=default_cache(),
        help=f"folder with the peers' environments (or the variable {CACHE_VARIABLE})",
    )  # fmt: skip
    parser.add_argument(
        "--samples", type=int, metavar="N",
        help="problems or scenes of each family (arm, collision), reaches (ik), picks (pick)",
    )  # fmt: skip
    options = parser.parse_args(arguments)
    os.environ.update(OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")
    report = _run(options.suite, options.quick, options.cache, options.samples)
    report.print(Console())
    if options.json is not None:
        options.json.write_text(json.dumps(report.to_json(), indent=1) + "\n", "utf-8")
    return 0


def _run(suite: str, quick: bool, cache: Path, samples: int | None) -> Report:
    # imported after the number of threads is set: numerical libraries read it when they are loaded
    from tools.benchmark.arm import arm
    from tools.benchmark.checker import checker
    from tools.benchmark.collision import collision
    from tools.benchmark.control import control
    from tools.benchmark.eyes import eyes
    from tools.benchmark.ik import ik
    from tools.benchmark.many_cores import many_cores
    from tools.benchmark.meshes import meshes
    from tools.benchmark.peers.environments import PeerEnvironment
    from tools.benchmark.pick import pick
    from tools.benchmark.planning import planning
    from tools.benchmark.report import Report
    from tools.benchmark.ros.joint_states import ros
    from tools.benchmark.startup import startup
    from tools.benchmark.tick import tick
    from tools.benchmark.timing import timing

    beside_peers: dict[str, Callable[[bool, Path, int | None], Report]] = {
        "pick": pick,
        "arm": arm,
        "ik": ik,
        "collision": collision,
    }
    if suite in beside_peers:
        return beside_peers[suite](quick, cache, samples)
    if suite == "timing":
        toppra = PeerEnvironment("toppra", cache)
        return Report(suite, quick, timing(quick, toppra.python if toppra.is_ready else None))
    alone = {
        "planning": planning,
        "meshes": meshes,
        "checker": checker,
        "tick": tick,
        "control": control,
        "ros": ros,
        "startup": startup,
        "eyes": eyes,
        "many_cores": many_cores,
    }
    if suite in _BROWSED or suite == "recording":  # what they need is not everywhere
        from tools.benchmark.served.recording import recording
        from tools.benchmark.served.view import view
        from tools.benchmark.served.view_long import view_long

        alone |= {"recording": recording, "view": view, "view_long": view_long}
    return Report(suite, quick, alone[suite](quick))


if __name__ == "__main__":
    sys.exit(main())
