"""Moving along a direction and turning, exactly as far, as long and as fast as is said, within limits."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace

from executive.language.commands import meanings
from executive.language.phrases.arranging import clause, trouble, unfit
from executive.language.phrases.parts import Parts, senses, words
from executive.language.phrases.values import EXCEEDS, Clause, Measure, draft

FORWARD_M_S = 0.3
"""Speed of ``move_forward``; backward is its negative."""

TURN_RAD_S = 0.5
"""Speed of ``turn_left``; to the right is its negative."""

MAX_LINEAR_M_S = 0.5
MAX_ANGULAR_RAD_S = 1.0
MAX_DISTANCE_M = 20.0
MAX_DURATION_S = 600.0

_LIMITS = {
    "duration": ("time", "s", MAX_DURATION_S),
    "distance": ("distance", "m", MAX_DISTANCE_M),
    "angle": ("angle", "rad", 4 * math.pi + 1e-9),
    "linear_speed": ("speed", "m/s", MAX_LINEAR_M_S),
    "angular_speed": ("turning speed", "rad/s", MAX_ANGULAR_RAD_S),
}
_LINEAR = {"forward": FORWARD_M_S, "ahead": FORWARD_M_S, "backward": -FORWARD_M_S, "back": -FORWARD_M_S}
_ANGULAR = {"left": TURN_RAD_S, "right": -TURN_RAD_S}
NO_DIRECTION = "in which direction?"


def bounded(measure: Measure, longest: float | None = None) -> float:
    """The value in SI units, if it is within the limits: what exceeds them is refused, never clamped.

    ``longest`` is another limit than that for motions.
    """
    name, unit, limit = _LIMITS[measure.of]
    limit = longest or limit
    value = f"{measure.value:g} {unit}"
    if measure.value <= 0:
        raise trouble(f"a {name} of {value} is nothing to do", value)
    if measure.value > limit:
        raise trouble(f"the {name} of {value} {EXCEEDS} {limit:g} {unit}", value)
    return measure.value


def _move(parts: Parts) -> Clause:
    measures: dict[str, float] = {}
    for one in (part for part in parts if isinstance(part, Measure)):
        if one.of in measures:
            raise unfit()
        measures[one.of] = bounded(one)
    linear, angular = _direction(parts, measures)
    linear = math.copysign(measures.get("linear_speed", abs(linear)), linear)
    angular = math.copysign(measures.get("angular_speed", abs(angular)), angular)
    duration, distance = measures.get("duration"), measures.get("distance")
    if "angle" in measures:
        duration = bounded(Measure("duration", measures["angle"] / abs(angular), ""))
    move = draft(
        "move",
        linear_m_s=round(linear, 3),
        angular_rad_s=round(angular, 3),
        duration_s=None if duration is None else round(duration, 3),
        distance_m=None if distance is None else round(distance, 3),
    )
    return clause(parts, [(move,)])


def _move_on(parts: Parts) -> Clause:
    """Terse: "forward 2 m", "left 90 degrees"; a mere "left" is no turn."""
    turned = any(isinstance(one, Measure) and one.of == "angle" for one in parts)
    if not words(parts, "FORWARD", "BACKWARD", *(("TURN_SIDE",) if turned else ())):
        raise unfit()
    return replace(_move(parts), terse=True)


def _direction(parts: Parts, measures: Mapping[str, float]) -> tuple[float, float]:
    """Signed speeds, in m/s and rad/s, of which one is zero."""
    headings = ("FORWARD", "BACKWARD", "BRIDGE", "BACK_UP", "TURN_SIDE", "LEFT_RIGHT")
    heading = next((one.meaning.partition(":")[0] for one in words(parts, *headings)), None)
    how = senses(parts, "MOVE")
    turns = bool(words(parts, "TURN", "A_TURN")) or heading in _ANGULAR
    if turns and not words(parts, "TURN", "A_TURN", "BRIDGE") and "angle" not in measures:
        raise trouble(f"moving sideways ({heading!r}) is no skill of this robot", heading)
    wrong = {"distance", "linear_speed"} if turns else {"angle", "angular_speed"}
    if wrong & set(measures) or ("duration" in measures and {"distance", "angle"} & set(measures)):
        raise unfit()
    if heading == "ahead" and not measures:
        raise trouble("walk ahead, or go on with what?", asks=True)
    if heading == "back" and not measures and "step" not in how:
        raise trouble("back to where, or backward?", asks=True)
    if heading is None and ("advance" in how or ("distance" in measures and "walk" in how)):
        heading = "forward"
    if heading is None:
        raise trouble("to the left or to the right?" if turns else NO_DIRECTION, asks=True)
    return (0.0, _ANGULAR[heading]) if turns else (_LINEAR[heading], 0.0)


def _turn_around(parts: Parts) -> Clause:
    duration_s = round(math.pi / TURN_RAD_S, 3)
    return clause(parts, [(draft("move", linear_m_s=0.0, angular_rad_s=TURN_RAD_S, duration_s=duration_s),)])


MEANINGS = meanings(
    {
        "move": _move,
        "move_on": _move_on,
        "turn_around": _turn_around,
    }
)
