"""Attaches a humanoid of Unitree: ``unitree`` in the group ``humanoid_executive.bodies``."""

from __future__ import annotations

from collections.abc import Mapping

from robots.clock import Clock
from robots.interface.bodies import BodyError, require_known
from robots.interface.hardware import RobotData
from robots.unitree.robot import UnitreeRobot

OPTIONS = ("interface", "domain", "arms")
_YES = {"yes": True, "no": False}


def attach(data: RobotData, clock: Clock, options: Mapping[str, str]) -> UnitreeRobot:
    """Wait for the robot's first state.

    Args:
        data: The robot's.
        clock: Time.
        options: ``interface``, the network interface that the robot is on (this machine alone when left
            out); ``domain`` of DDS, 0 when left out; ``arms``: ``yes`` commands arms and waist alone, by
            ``arm_sdk``.

    Raises:
        BodyError: cyclonedds is not installed, or an option is wrong.
        SilentRobotError: No state came.
    """
    require_known(options, OPTIONS)
    arms, domain = options.get("arms", "no"), options.get("domain", "0")
    if arms not in _YES:
        raise BodyError(f"arms: expected yes or no, not {arms!r}")
    if not (domain.isascii() and domain.isdigit() and int(domain) <= 232):
        raise BodyError(f"domain: expected a number from 0 to 232, not {domain!r}")
    try:
        from robots.unitree.dds import LOOPBACK, controller_end, controller_hand_end
    except ModuleNotFoundError as missing:
        if (missing.name or "").partition(".")[0] != "cyclonedds":
            raise
        raise BodyError(
            "a robot of Unitree takes cyclonedds: pip install 'humanoid-executive[ros]'"
        ) from missing
    network = int(domain), options.get("interface", LOOPBACK)
    hands = {hand: controller_hand_end(hand, *network) for hand in data.description.grippers}
    end = controller_end(*network, arms_only=_YES[arms])
    return UnitreeRobot(data, end, clock, hands, arms_only=_YES[arms])
