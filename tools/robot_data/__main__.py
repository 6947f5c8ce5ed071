"""``python -m tools.robot_data``: draft a robot's folder, and try a checked reach with it."""

from __future__ import annotations

import argparse
import sys

from tools.robot_data import new, reach


def main() -> int:
    """Read the command line; the exit code."""
    parser = argparse.ArgumentParser(prog="tools.robot_data", description=__doc__)
    commands = parser.add_subparsers(required=True)
    for name, module in (("new", new), ("reach", reach)):
        summary, _, rest = (module.__doc__ or "").partition("\n")
        command = commands.add_parser(
            name,
            help=summary,
            description=summary + rest,
            formatter_class=argparse.RawDescriptionHelpFormatter,
        )
        module.add_arguments(command)
        command.set_defaults(run=module.run)
    chosen = parser.parse_args()
    return int(chosen.run(chosen))


if __name__ == "__main__":
    sys.exit(main())
