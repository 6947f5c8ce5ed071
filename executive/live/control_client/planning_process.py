"""The planning process of a served robot: ``python -m executive.live.control_client.planning_process``.

It does nothing but serve: what it sends home must not be defined in a process's main module.
"""

from __future__ import annotations

import sys

from executive.live.control_client.planning_service import PlanningService
from robots.live.wire.child_process import serve_parent


def main() -> None:
    """Serve the parent whose pipe is the last argument."""
    serve_parent(int(sys.argv[2]), PlanningService(sys.argv[1]).answer)


if __name__ == "__main__":
    main()
