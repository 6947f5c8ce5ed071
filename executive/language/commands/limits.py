"""How far, long and fast a motion may be that is asked for, and what is said of more."""

from __future__ import annotations

import math

from executive.language.phrases.arranging import TroubleError, trouble
from executive.language.phrases.values import EXCEEDS, Measure, Trouble

MAX_LINEAR_M_S = 0.5
MAX_ANGULAR_RAD_S = 1.0
MAX_DISTANCE_M = 20.0
MAX_DURATION_S = 600.0

_UNITS = {"duration": "s", "distance": "m", "angle": "rad", "linear_speed": "m/s", "angular_speed": "rad/s"}
_LIMITS = {
    "duration": MAX_DURATION_S,
    "distance": MAX_DISTANCE_M,
    "angle": 4 * math.pi + 1e-9,
    "linear_speed": MAX_LINEAR_M_S,
    "angular_speed": MAX_ANGULAR_RAD_S,
}
_NAMES = {
    "duration": "time",
    "distance": "distance",
    "angle": "angle",
    "linear_speed": "speed",
    "angular_speed": "turning speed",
}


class ExceededError(TroubleError):
    """A limit is exceeded, which holds however the rest is read."""


def in_words(measure: Measure) -> str:
    """A measure with its unit."""
    return f"{measure.value:g} {_UNITS[measure.of]}"


def bounded(measure: Measure, longest: float | None = None) -> float:
    """The value, if it is within the limits: what exceeds them is refused, never clamped."""
    limit, unit, name = longest or _LIMITS[measure.of], _UNITS[measure.of], _NAMES[measure.of]
    value = in_words(measure)
    if measure.value <= 0:
        raise trouble(f"a {name} of {value} is nothing to do", value)
    if measure.value > limit:
        raise ExceededError(Trouble(f"the {name} of {value} {EXCEEDS} {limit:g} {unit}", value))
    return measure.value
