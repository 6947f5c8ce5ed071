"""Which episode to run."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

if TYPE_CHECKING:  # a process that only hands out orders builds no world
    from robots.clock import ManualClock
    from robots.interface.robot import Robot
    from robots.simulated.world import SimulatedWorld


@dataclass(frozen=True, slots=True)
class EpisodeOrder:
    """What to run.

    Attributes:
        seed: Seed of scene and run.
        robot: Name of the robot.
        fault: Name of a fault, or None.
        scene: A scene's name or file that the random ones are made from, or None.
        wire: Whether its body is behind its own low-level interface, played with a delay and losses.
        perception: "stub" or "rgbd"; None is what the scene says.
    """

    seed: int
    robot: str = "talos"
    fault: str | None = None
    scene: str | None = None
    perception: str | None = None
    wire: bool = False


def body_for(order: EpisodeOrder) -> Callable[[SimulatedWorld, ManualClock], Robot] | None:
    """What is commanded in the place of the world's own robot; None for that itself."""
    if not order.wire:
        return None
    from tools.unitree.over_the_wire import over_the_wire

    return partial(over_the_wire, seed=order.seed)
