"""Numbers of finding, counting and describing; each with its reason."""

from __future__ import annotations

from dataclasses import dataclass

from trees.policy import Gaze


@dataclass(frozen=True, slots=True)
class TellingSettings:
    """Numbers of finding, counting and describing.

    Attributes:
        inventory_gazes: The looks that together see everything within reach of the arms, the near corners of
            a table beside the robot at last.
        looks_past: How often, after all gazes, the eyes are taken elsewhere, past what hides something.
        confidence_slope, confidence_offset: From how surely things were seen to how often answers about
            them are right, a line in the log-odds; fitted by ``tools.calibration``.
    """

    inventory_gazes: tuple[Gaze, ...] = (
        Gaze("ahead", tilt_rad=0.75),
        Gaze("left", tilt_rad=0.7, pan_rad=0.6),
        Gaze("right", tilt_rad=0.7, pan_rad=-0.6),
        Gaze("near", tilt_rad=0.77, lean_rad=0.5),
        Gaze("near left", tilt_rad=0.7, pan_rad=-0.4, lean_rad=0.5, turn_rad=0.7),
        Gaze("near right", tilt_rad=0.7, pan_rad=0.4, lean_rad=0.5, turn_rad=-0.7),
        Gaze("beside left", tilt_rad=0.77, pan_rad=0.2, lean_rad=0.35, turn_rad=0.4),
        Gaze("beside right", tilt_rad=0.77, pan_rad=-0.2, lean_rad=0.35, turn_rad=-0.4),
    )
    looks_past: int = 6
    confidence_slope: float = 0.85
    confidence_offset: float = 1.7
