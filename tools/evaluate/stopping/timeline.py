"""What a run of a course does when: its phases, and how fast the arms move."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from executive.session.events import Event, TaskAccepted, TaskEnded
from tools.evaluate.stopping.courses import MOVING_PHASES, WALK, Course, CourseRun, phase_of
from trees.events import NodeChanged

MOVING_RAD_S = 0.1
"""An arm joint that is faster than this moves."""
_EVERY = 5
_ROOM_S = 0.05
"""Instants of one run are at least this far apart."""


@dataclass(frozen=True, slots=True)
class Moment:
    """One instant of a run.

    Attributes:
        t_s: Simulated time.
        phase: What was under way.
        arm_rad_s: True speed of the fastest arm joint.
        body_rad_s: True speed of the fastest joint of all but the fingers.
    """

    t_s: float
    phase: str
    arm_rad_s: float
    body_rad_s: float = 0.0


def record(course: Course, seed: int, robot: str) -> list[Moment]:
    """Run a course to its end, and remember every hundredth of a second of it."""
    moments: list[Moment] = []
    phase, periods = "", 0

    def take(event: Event) -> None:
        nonlocal phase
        if isinstance(event, NodeChanged) and event.status == "running":
            phase = phase_of(event.where)
        elif isinstance(event, TaskAccepted):
            phase = "plan"
        elif isinstance(event, TaskEnded):
            phase = "hold"

    run = CourseRun(course, seed, robot, take)
    truth, description = run.assembly.world.truth, run.assembly.model.description
    arms = [
        i for i, name in enumerate(description.actuated) if any(name in description.groups[g] for g in _ARMS)
    ]

    def look() -> None:
        nonlocal periods
        periods += 1
        if periods % _EVERY == 0 and phase:
            speeds = np.abs(truth.joint_velocities())
            fastest = float(speeds[arms].max()), float(speeds[: len(description.joints)].max())
            moments.append(Moment(run.assembly.clock.now_s(), phase, *fastest))

    run.assembly.session.watch_periods(look)
    run.run()
    return moments


def choose(moments: Sequence[Moment], wanted: Sequence[str], rng: np.random.Generator) -> list[Moment]:
    """Draw one instant for each wanted phase, in the order of time.

    In phases of motion an arm joint moves at the instant, in a walk any joint. Where a run never comes to
    a phase, any instant of motion is drawn in its place.
    """
    chosen: list[Moment] = []
    for phase in wanted:
        free = [m for m in moments if all(abs(m.t_s - other.t_s) >= _ROOM_S for other in chosen)]
        moving = [m for m in free if m.arm_rad_s > MOVING_RAD_S]
        if phase == WALK:
            moving = [m for m in free if m.body_rad_s > MOVING_RAD_S]
        in_motion = phase in (*MOVING_PHASES, WALK)
        fitting = [m for m in (moving if in_motion else free) if m.phase == phase]
        pool = fitting or moving or free
        if pool:
            chosen.append(pool[int(rng.integers(len(pool)))])
    return sorted(chosen, key=lambda moment: moment.t_s)


_ARMS = ("left_arm", "right_arm")
