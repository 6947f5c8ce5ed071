"""The suites over the ROS door, by name; what they need beyond the product is looked for when one is run."""

from __future__ import annotations

import argparse

from rich.console import Console

from executive.doors.companion import require_extra
from executive.errors import UserError

ROS_SUITES = ("ros_velocity", "ros_hostile", "ros_action")


def run_ros_suite(options: argparse.Namespace, messages: Console) -> int:
    """Run one; 0 when everything was as it has to be, 2 when something that it needs is missing."""
    try:
        require_extra("ros", "cyclonedds")
    except UserError as missing:
        messages.print(f"error: {missing}", style="bold", markup=False)
        return 2
    if options.suite == "ros_velocity":
        from tools.evaluate.ros.velocity import run_ros_velocity

        return run_ros_velocity(options, messages)
    if options.suite == "ros_hostile":
        from tools.evaluate.ros.hostile_samples import run_ros_hostile

        return run_ros_hostile(options, messages)
    from tools.evaluate.ros.action import run_ros_action

    return run_ros_action(options, messages)
