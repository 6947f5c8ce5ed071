"""Where one joint comes to rest, and how to steer that place: one control period after the other.

A joint's setpoint is (q, v, a), with ``a`` the change of speed in the last period by its length. A period
takes a new acceleration, no more than ``change`` away from the last, and adds it up:

    v' = v + a' dt,    q' = q + (v + v') dt / 2.

From every state there is one hardest way to rest, a new acceleration for each period, and so one place
where the joint rests if it brakes. That place only rises with the next acceleration, so it can be
steered: on to where the joint shall go, and from then on the joint brakes. Limits of acceleration and jerk
are kept from any state that keeps them, and nothing goes beyond the place but what could not be braked
before it.
"""

from __future__ import annotations

import math

from kinematics.compiled.compiler import compiled

_HALVINGS = 60
"""Of the range in which the next acceleration is searched: to rounding."""
_LONGEST = 1_000_000
"""Periods after which a joint rests, whatever the limits; only so that the loop has an end."""
_RESTS_RAD_S = 1e-9


@compiled
def fading(v: float, dt: float, change: float) -> float:
    """Acceleration that takes a speed away exactly, if from the next period on it fades by ``change``."""
    # After n + 1 periods, the first with x: (n + 1) (x - n change / 2).
    sum_of = abs(v) / dt
    n = math.floor(0.5 * (math.sqrt(1.0 + 8.0 * sum_of / change) - 1.0))
    return -math.copysign(sum_of / (n + 1.0) + 0.5 * n * change, v)


@compiled
def braking(v: float, a: float, dt: float, most: float, change: float) -> float:
    """Acceleration of the next period on the hardest way to rest.

    Args:
        v, a: Speed and acceleration now, rad/s and rad/s^2.
        dt: The period, s.
        most: Largest acceleration.
        change: Largest change of it from one period to the next.
    """
    return min(max(fading(v, dt, change), a - change, -most), a + change, most)


@compiled
def rest_point(q: float, v: float, a: float, dt: float, most: float, change: float) -> float:
    """Where a joint comes to rest that brakes from here on."""
    for _ in range(_LONGEST):
        if abs(v) < _RESTS_RAD_S and abs(a) <= change:
            break
        a = braking(v, a, dt, most, change)
        q += dt * (v + 0.5 * a * dt)
        v += a * dt
    return q


@compiled
def steered(
    target: float, q: float, v: float, a: float, dt: float, fastest: float, most: float, change: float
) -> float:
    """Acceleration of the next period that brings the place of rest nearest to the target.

    Args:
        target: Where to rest, rad.
        q, v, a: The setpoint now.
        dt: The period, s.
        fastest: Largest speed; a joint that is faster slows down to it.
        most: Largest acceleration.
        change: Largest change of it from one period to the next.
    """
    least, largest = max(a - change, -most), min(a + change, most)
    # Speeds that are reached after the acceleration has faded, kept below the fastest.
    high = min(max(fading(v - fastest, dt, change), least), largest)
    low = min(max(fading(v + fastest, dt, change), least), largest)
    if _rest_after(high, q, v, dt, most, change) <= target:
        return high
    if _rest_after(low, q, v, dt, most, change) >= target:
        return low
    for _ in range(_HALVINGS):
        middle = 0.5 * (low + high)
        if _rest_after(middle, q, v, dt, most, change) > target:
            high = middle
        else:
            low = middle
    return 0.5 * (low + high)


@compiled
def _rest_after(a: float, q: float, v: float, dt: float, most: float, change: float) -> float:
    """Where the joint rests when the next period has this acceleration."""
    return rest_point(q + dt * (v + 0.5 * a * dt), v + a * dt, a, dt, most, change)
