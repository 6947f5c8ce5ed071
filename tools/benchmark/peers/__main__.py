"""``python -m tools.benchmark.peers [NAME ...] [--cache DIR]``: make the peers' environments."""

from __future__ import annotations

import argparse
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

from tools.benchmark.peers.environments import (
    ASSET_NAMES,
    CACHE_VARIABLE,
    MODEL_NAMES,
    NAMES,
    ROS_NAMES,
    PeerEnvironment,
    default_cache,
)


def main(arguments: Sequence[str] | None = None) -> int:
    """Make each named environment, or all; tell which could not be made."""
    parser = argparse.ArgumentParser(
        prog="python -m tools.benchmark.peers", description="Install the peers, each on its own."
    )
    parser.add_argument(
        "names",
        nargs="*",
        choices=[*NAMES, *ROS_NAMES, *MODEL_NAMES, *ASSET_NAMES, []],
        metavar="NAME",
        help=", ".join((*NAMES, *ROS_NAMES, *MODEL_NAMES, *ASSET_NAMES)),
    )
    parser.add_argument(
        "--cache", type=Path, default=default_cache(), help=f"folder (or the variable {CACHE_VARIABLE})"
    )
    options = parser.parse_args(arguments)
    failed = 0
    for name in options.names or NAMES:
        environment = PeerEnvironment(name, options.cache)
        try:
            environment.make()
        except subprocess.CalledProcessError as error:
            failed += 1
            print(f"{name}: not installed ({error})", file=sys.stderr)
        else:
            print(f"{environment.version} in {environment.python.parent.parent}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
