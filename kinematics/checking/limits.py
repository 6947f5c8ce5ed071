"""Joint limits over the whole of a trajectory, in closed form on each cubic piece.

Position, velocity and acceleration are judged at their extremes inside each segment. The jerk of a
cubic is constant in a segment; at a sample the acceleration may step, and that step is judged as
jerk over the spacing of the samples. Both are weighted averages of the jerk of any smooth motion
that the samples were taken from, so a motion within its jerk limit is never refused for sampling.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.checking.settings import CheckSettings
from kinematics.checking.timeline import Timeline
from kinematics.model.robot_model import RobotModel
from kinematics.motion.verdict import Finding, FindingKind

Mask = NDArray[np.bool_]


def jump_intervals(model: RobotModel, timeline: Timeline, settings: CheckSettings) -> Array:
    """Beginnings and ends of the segments that no motion within reason joins, shape (n, 2), s."""
    early, late = timeline.accelerations()
    jumps = np.flatnonzero(_jumps(model, early, late, settings).any(axis=1))
    return np.column_stack([timeline.t_s[jumps], timeline.t_s[jumps + 1]])


def limit_findings(model: RobotModel, timeline: Timeline, settings: CheckSettings) -> list[Finding]:
    """Judge every joint against its limits; one finding for each joint and kind of limit."""
    early, late = timeline.accelerations()
    strongest = np.maximum(np.abs(early), np.abs(late))
    jumps = _jumps(model, early, late, settings)
    findings = _worst(
        FindingKind.DISCONTINUITY, model, timeline.t_s[:-1], strongest, model.acceleration, jumps
    )
    findings += _position(model, timeline, settings)
    findings += _velocity(model, timeline, settings, early, late)
    over = strongest > model.acceleration * (1.0 + settings.acceleration_fraction)
    late_is_worse = np.abs(late) > np.abs(early)
    when = np.where(late_is_worse, timeline.t_s[1:, None], timeline.t_s[:-1, None])
    findings += _worst(
        FindingKind.ACCELERATION_LIMIT, model, when, strongest, model.acceleration, over & ~jumps
    )
    return findings + _jerk(model, timeline, settings, early, late, jumps)


def _jumps(model: RobotModel, early: Array, late: Array, settings: CheckSettings) -> Mask:
    strongest = np.maximum(np.abs(early), np.abs(late))
    return np.asarray(strongest > settings.discontinuity_factor * model.acceleration)


def base_findings(timeline: Timeline, angular: Array, settings: CheckSettings) -> list[Finding]:
    """Judge whether base poses and base velocities belong together.

    Args:
        timeline: The motion.
        angular: Angular velocity of the base at the samples, in its own frame, shape (n, 3).
        settings: Tolerances.
    """
    h = timeline.spacing_s
    mean = 0.5 * (timeline.base_velocity[:-1] + timeline.base_velocity[1:])
    gap = np.linalg.norm(np.diff(timeline.base_position_m, axis=0) - mean * h[:, None], axis=1)
    turn = np.linalg.norm(0.5 * (angular[:-1] + angular[1:]), axis=1) * h
    findings = []
    for what, value, limit in (
        ("base position", gap, settings.base_jump_m),
        ("base orientation", np.abs(timeline.base_turn_rad - turn), settings.base_jump_rad),
    ):
        bad = np.flatnonzero(value > limit)
        if len(bad):
            t_s = float(timeline.t_s[bad[0]])
            findings.append(Finding(FindingKind.DISCONTINUITY, t_s, (what,), float(value[bad].max()), limit))
    return findings


def _position(model: RobotModel, timeline: Timeline, settings: CheckSettings) -> list[Finding]:
    h = timeline.spacing_s[:, None]
    q, v = timeline.joints_rad, timeline.joint_velocity
    lower, upper = model.lower_rad - settings.position_rad, model.upper_rad + settings.position_rad
    third = h / 3.0
    after, before_next = q[:-1] + v[:-1] * third, q[1:] - v[1:] * third
    # a cubic stays within its control points: only the others need their extremes
    outside = (q < lower) | (q > upper)
    suspect = (after < lower) | (after > upper) | (before_next < lower) | (before_next > upper)
    suspects = np.argwhere(suspect | outside[:-1] | outside[1:])
    findings: dict[int, Finding] = {}
    for i, joint in suspects:
        times, values = _extremes(timeline, int(i), int(joint))
        for t_s, value in sorted(zip(times, values, strict=True)):
            if lower[joint] <= value <= upper[joint]:
                continue
            limit = float(model.lower_rad[joint] if value < lower[joint] else model.upper_rad[joint])
            before = findings.get(int(joint))
            if before is None:
                findings[int(joint)] = Finding(
                    FindingKind.POSITION_LIMIT, t_s, (model.joints[joint],), value, limit
                )
            elif before.limit == limit and abs(value - limit) > abs(before.value - limit):
                findings[int(joint)] = Finding(before.kind, before.t_s, before.subject, value, limit)
    return list(findings.values())


def _extremes(timeline: Timeline, i: int, joint: int) -> tuple[list[float], list[float]]:
    """Times and values of the ends and inner extremes of one joint in one segment."""
    h = float(timeline.spacing_s[i])
    q0, q1 = timeline.joints_rad[i : i + 2, joint]
    m0, m1 = timeline.joint_velocity[i : i + 2, joint] * h
    change = q1 - q0
    # dq/du = m0 + 2 (3 change - 2 m0 - m1) u + 3 (m0 + m1 - 2 change) u^2
    roots = np.roots([3.0 * (m0 + m1 - 2.0 * change), 2.0 * (3.0 * change - 2.0 * m0 - m1), m0])
    inner = [float(root.real) for root in roots if abs(root.imag) < 1e-9 and 0.0 < root.real < 1.0]
    fractions = [0.0, *inner, 1.0]
    values = [
        float(q0 + u * change + u * (1 - u) * ((1 - u) * (m0 - change) + u * (change - m1)))
        for u in fractions
    ]
    return [float(timeline.t_s[i] + u * h) for u in fractions], values


def _velocity(
    model: RobotModel, timeline: Timeline, settings: CheckSettings, early: Array, late: Array
) -> list[Finding]:
    limit = model.velocity * (1.0 + settings.velocity_fraction)
    v = timeline.joint_velocity
    # a quadratic stays within its control points: mostly they tell that there is nothing to find
    control = v[:-1] + (0.5 * timeline.spacing_s[:, None]) * early
    if (np.abs(v) <= limit).all() and (np.abs(control) <= limit).all():
        return []
    speed, when = _speed(timeline, early, late)
    return _worst(FindingKind.VELOCITY_LIMIT, model, when, speed, model.velocity, speed > limit)


def _speed(timeline: Timeline, early: Array, late: Array) -> tuple[Array, Array]:
    """Largest speed in each segment and when, shape (n - 1, k) each."""
    h = timeline.spacing_s[:, None]
    v = timeline.joint_velocity
    change = late - early
    with np.errstate(divide="ignore", invalid="ignore"):
        u = -early / change
    inner = (u > 0.0) & (u < 1.0)
    u = np.where(inner, u, 0.0)
    vertex = v[:-1] + h * u * (early + 0.5 * change * u)
    candidates = np.abs(np.stack([v[:-1], vertex, v[1:]]))
    which = candidates.argmax(axis=0)
    fraction = np.choose(which, [np.zeros_like(u), u, np.ones_like(u)])
    return candidates.max(axis=0), timeline.t_s[:-1, None] + fraction * h


def _jerk(
    model: RobotModel, timeline: Timeline, settings: CheckSettings, early: Array, late: Array, jumps: Mask
) -> list[Finding]:
    h = timeline.spacing_s
    limit = model.jerk * (1.0 + settings.jerk_fraction)
    inside = np.abs(late - early) / h[:, None]
    window = np.minimum(0.5 * (h[:-1] + h[1:]), settings.jerk_window_s)
    step = np.abs(early[1:] - late[:-1]) / window[:, None]
    middle = 0.5 * (early + late)
    spread = np.abs(np.diff(middle, axis=0)) / (0.5 * (h[:-1] + h[1:]))[:, None]
    at_sample = np.maximum(step, spread)
    beside_jump = jumps[:-1] | jumps[1:]
    over_inside, over_at_sample = (inside > limit) & ~jumps, (at_sample > limit) & ~beside_jump
    if not over_inside.any() and not over_at_sample.any():
        return []
    values = np.concatenate([inside, at_sample])
    times = np.concatenate([timeline.t_s[:-1], timeline.t_s[1:-1]])
    over = np.concatenate([over_inside, over_at_sample])
    order = np.argsort(times, kind="stable")
    return _worst(FindingKind.JERK_LIMIT, model, times[order], values[order], model.jerk, over[order])


def _worst(
    kind: FindingKind, model: RobotModel, times_s: Array, values: Array, limits: Array, over: Mask
) -> list[Finding]:
    """One finding for each joint that is over its limit: the first time, the worst value."""
    findings = []
    for joint in np.flatnonzero(over.any(axis=0)):
        bad = np.flatnonzero(over[:, joint])
        when = times_s[bad[0]] if times_s.ndim == 1 else times_s[bad[0], joint]
        findings.append(
            Finding(
                kind,
                float(when),
                (model.joints[joint],),
                float(values[bad, joint].max()),
                float(limits[joint]),
            )
        )
    return findings
