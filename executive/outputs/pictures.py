"""A picture of the end of a run, and a film of all of it."""

from __future__ import annotations

from pathlib import Path

from robots.errors import RobotsError
from robots.simulated import rendering
from robots.simulated.world import SimulatedWorld


class Pictures:
    """Makes what was asked for. A film that breaks off does not disturb the robot.

    Args:
        snapshot: Where to write a picture of the end, or None.
        video: Where to write a film, or None.

    Raises:
        RenderingUnavailableError: This machine cannot draw; found out before anything moves.
    """

    def __init__(self, snapshot: Path | None, video: Path | None) -> None:
        rendering.require_rendering(video=video is not None)
        self._snapshot, self._video = snapshot, video
        self._recorder: rendering.VideoRecorder | None = None
        self.complaints: list[str] = []

    def begin(self, world: SimulatedWorld) -> None:
        """Start the film."""
        if self._video is not None:
            self._recorder = rendering.VideoRecorder(world, self._video)

    def tick(self) -> None:
        """Draw a frame of the film if one is due; call it after each control period."""
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
                rendering.snapshot(world, self._snapshot)
        except (RobotsError, OSError) as failed:
            self.complaints.append(f"no picture: {failed}")
