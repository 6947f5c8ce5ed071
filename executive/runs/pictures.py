"""A picture of the end of a run, and a film of all of it."""

from __future__ import annotations

import math
from pathlib import Path

from robots.errors import RobotsError
from robots.simulated.pictures import rendering
from robots.simulated.world import SimulatedWorld

_POINT_EVERY_M = 0.04
_WALKED_POINTS = 8
"""A robot that has gone so far is shown from above, with its way; one that has only leaned over is not."""


class Pictures:
    """Makes the picture and the film that a run was asked for; a film that breaks off leaves the robot alone.

    Args:
        snapshot: Where to write a picture of the end, or None.
        video: Where to write a film, or None.
        panel: Draws what stands beside the frames of the film, of so many pixels' height, at a time; None for
            nothing.

    Raises:
        RenderingUnavailableError: This machine cannot draw; found out before anything moves.
    """

    def __init__(
        self, snapshot: Path | None, video: Path | None, panel: rendering.Panel | None = None
    ) -> None:
        rendering.require_rendering(video=video is not None)
        self._snapshot, self._video, self._panel = snapshot, video, panel
        self._recorder: rendering.VideoRecorder | None = None
        self._world: SimulatedWorld | None = None
        self._path: list[tuple[float, float]] = []
        self.complaints: list[str] = []

    def begin(self, world: SimulatedWorld) -> None:
        """Start the film, and note the way that the robot goes."""
        self._world = world
        if self._video is not None:
            self._recorder = rendering.VideoRecorder(world, self._video, panel=self._panel)

    def tick(self) -> None:
        """Draw a frame of the film if one is due; call it after each control period."""
        self._note_place()
        if self._recorder is not None:
            try:
                self._recorder.tick()
            except (RobotsError, OSError) as failed:
                self.complaints.append(f"the film broke off: {failed}")
                self._recorder = None

    def finish(self, world: SimulatedWorld) -> None:
        """Close the film and take the picture."""
        try:
            if self._recorder is not None:
                self._recorder.close()
            if self._snapshot is not None:
                walked = len(self._path) > _WALKED_POINTS
                rendering.snapshot(
                    world,
                    self._snapshot,
                    camera="plan" if walked else "overview",
                    walked=self._path if walked else (),
                )
        except (RobotsError, OSError) as failed:
            self.complaints.append(f"no picture: {failed}")

    def _note_place(self) -> None:
        """Keep a point of the path each few centimetres."""
        if self._world is None:
            return
        x, y = (float(value) for value in self._world.truth.world_T_base()[:2, 3])
        if not self._path or math.dist((x, y), self._path[-1]) > _POINT_EVERY_M:
            self._path.append((x, y))
