"""Which episode to run."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class EpisodeOrder:
    """What to run.

    Attributes:
        seed: Seed of scene and run.
        robot: Name of the robot.
        fault: Name of a fault, or None.
        scene: A scene's name or file that the random ones are made from, or None.
        perception: "stub" or "rgbd"; None is what the scene says.
    """

    seed: int
    robot: str = "talos"
    fault: str | None = None
    scene: str | None = None
    perception: str | None = None
