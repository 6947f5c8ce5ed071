"""One episode: a whole task, in which a part of the body breaks."""

from __future__ import annotations

import math
import traceback
from dataclasses import dataclass
from typing import Literal

import numpy as np

from executive.session.events import Event, TaskEnded
from executive.session.task_result import chain
from executive.understanding.command_parser import parse
from robots.control.events import HealthChanged
from tools.evaluate.ailing.body_fault import BODY_FAULTS, BodyFault, struck_joint
from tools.evaluate.ailing.fault_record import FaultRecord
from tools.evaluate.scenes import TARGET, episode_rng, workspace_of
from tools.evaluate.stopping.courses import PICKS, CourseRun, phase_of
from trees.events import NodeChanged

WHEN_S = (0.5, 14.0)
"""The part breaks at a time drawn from here; a pick takes about 12 s."""
WATCHED_S = 10.0
_LAST_S = 1.0
_BRAKED_S = 0.5
"""A command that is ended by the fault itself may have had to brake until then."""
_SHOWN_RAD = 0.02
_SHOWN_MARGIN = 1.2
"""Over what a servo yields to the effort that counts as contact: a jam has to be noticed from there."""
_REST_EVERY = 5


@dataclass(frozen=True, slots=True)
class FaultOrder:
    """Which episode to run."""

    seed: int
    fault: str
    robot: str = "talos"


def run_faults(order: FaultOrder) -> list[FaultRecord]:
    """Run one episode; whatever breaks becomes its record."""
    try:
        return [_Episode(order).run()]
    except Exception:
        return [FaultRecord(order.seed, order.fault, error=traceback.format_exc())]


def died(order: FaultOrder) -> list[FaultRecord]:
    """The record of an episode whose process died."""
    return [FaultRecord(order.seed, order.fault, error="the process died")]


_STOOD_S = 1.0
"""So long after a cancel it stands still."""
Standing = Literal["home", "there"]
"""Where a robot stands still that a fault strikes: at home, or as it was when it was struck in its task."""


class _Episode:
    def __init__(self, order: FaultOrder, standing: Standing | None = None) -> None:
        self._order, self._standing = order, standing
        rng = episode_rng(order.seed, 4)
        self._fault: BodyFault = BODY_FAULTS[order.fault]
        self._run = CourseRun(PICKS[workspace_of(order.robot)], order.seed, order.robot, self._take)
        assembly = self._run.assembly
        description, hardware = assembly.model.description, assembly.world.robot.hardware
        joint = struck_joint(description, rng)
        self._part = joint if self._fault.of_a_joint else ""
        self._index = description.actuated.index(joint)
        gain, most_nm = hardware.gains[joint], description.limits[joint].effort
        self._servo = gain.stiffness / most_nm, gain.damping / most_nm, 1.0 / most_nm
        contact_nm = hardware.contact_effort_nm.get(joint, np.inf)
        self._shown_rad = min(_SHOWN_RAD, _SHOWN_MARGIN * contact_nm / gain.stiffness)
        when_s = float(rng.uniform(*WHEN_S))
        self._halted_s = when_s if standing == "there" else math.inf
        self._t_s = 1.0 if standing == "home" else when_s + (_STOOD_S if standing == "there" else 0.0)
        self._phase, self._struck_phase = "", ""
        self._struck = False
        self._noticed: HealthChanged | None = None
        self._ended: list[TaskEnded] = []
        self._asked = [np.inf, -np.inf]
        self._off_rad = self._asked_share = 0.0
        self._late: float | None = None
        self._fell = False
        self._periods = 0

        def strike() -> None:
            self._struck, self._struck_phase = True, self._phase
            self._fault.act(assembly.world.body_faults, joint, rng)

        assembly.world.faults.at(self._t_s, strike)
        assembly.session.watch_periods(self._look)

    def run(self) -> FaultRecord:
        assembly = self._run.assembly
        session, truth = assembly.session, assembly.world.truth
        if self._standing != "home":
            self._run.run()
        if self._standing is not None:
            session.hold(self._t_s + WATCHED_S - assembly.clock.now_s())
            return self._record(False, False)
        claimed_falsely = any(
            ended.outcome == "done"
            and "pick" in ended.text
            and truth.lift_m(TARGET) < 0.05
            and not self._fell
            for ended in self._ended[-1:]
        )
        left_s = self._t_s + WATCHED_S - assembly.clock.now_s()
        session.hold(max(left_s, 2.0))
        unnoticed = self._noticed is None
        refused = self._next_is_refused()
        session.hold(_BRAKED_S)
        if unnoticed and self._noticed is not None:  # that command showed it: the one after it is refused
            refused = self._next_is_refused()
        self._late = 0.0
        session.hold(_LAST_S)
        return self._record(refused, claimed_falsely)

    def _next_is_refused(self) -> bool:
        (command,) = parse("go home").commands
        result = self._run.assembly.session.run_task(command)
        return result.outcome == "refused" and result.failure is not None and bool(result.failure.message)

    def _record(self, refused: bool, claimed_falsely: bool) -> FaultRecord:
        noticed, ended = self._noticed, self._ended[0] if self._ended else None
        tops = chain(ended.failure) if ended is not None else []
        expected = {ailment.value for ailment in self._fault.noticed_as}
        typed = noticed is not None and noticed.ailment in expected
        typed = typed and noticed is not None and self._is_blamed(noticed.part)
        fells_standing = None
        if self._fell and self._standing is None:
            stands: tuple[Standing, ...] = ("home", "there")
            fells_standing = any(_Episode(self._order, standing).run().fell for standing in stands)
        low, high = self._asked
        return FaultRecord(
            seed=self._order.seed,
            fault=self._order.fault,
            part=self._part,
            t_s=round(self._t_s, 3),
            phase=self._struck_phase,
            noticed_s=None if noticed is None else round(noticed.t_s - self._t_s, 3),
            ailment="" if noticed is None else noticed.ailment,
            blamed="" if noticed is None else noticed.part,
            outcome="" if ended is None else ended.outcome,
            claimed_falsely=claimed_falsely,
            failure_kind=tops[0].kind.value if tops else None,
            asked_rad=round(max(high - low, 0.0), 4),
            off_rad=round(self._off_rad, 4),
            asked_share=round(self._asked_share, 3),
            shown_rad=round(self._shown_rad, 4),
            refused=refused,
            state=self._run.assembly.supervisor.lifecycle.state.value,
            late_rad_s=round(self._late or 0.0, 4),
            fell=self._fell,
            fells_standing=fells_standing,
            typed=typed,
            of_a_motor=self._fault.of_a_motor,
        )

    def _is_blamed(self, part: str) -> bool:
        legs = all(name.startswith("leg_") for name in (part, self._part))
        return self._part in ("", part) or (self._order.fault == "joint_stuck" and legs)

    def _take(self, event: Event) -> None:
        if isinstance(event, HealthChanged) and event.present and self._noticed is None:
            self._noticed = event
        elif isinstance(event, NodeChanged) and event.status == "running":
            self._phase = phase_of(event.where)
        elif isinstance(event, TaskEnded):
            self._ended.append(event)
            self._phase = "hold"

    def _look(self) -> None:
        assembly, i = self._run.assembly, self._index
        truth = assembly.world.truth
        self._periods += 1
        if assembly.clock.now_s() >= self._halted_s:
            self._halted_s, self._run.stopped = math.inf, True
            assembly.session.cancel("it is to stand still")
        if self._struck:
            setpoint = assembly.loop.setpoint
            wanted = float(setpoint.q[i])
            self._asked = [min(self._asked[0], wanted), max(self._asked[1], wanted)]
            off_rad = wanted - float(truth.joint_positions()[i])
            self._off_rad = max(self._off_rad, abs(off_rad))
            slower_rad_s = float(setpoint.v[i]) - float(truth.joint_velocities()[i])
            stiffness, damping, effort = self._servo
            share = stiffness * off_rad + damping * slower_rad_s + effort * float(setpoint.tau[i])
            self._asked_share = max(self._asked_share, abs(share))
        if self._periods % _REST_EVERY == 0:
            self._fell = self._fell or truth.fallen()
        if self._late is not None:
            speed = np.abs(truth.joint_velocities()[: len(assembly.model.joints)])
            if self._fault.of_a_motor and i < len(speed):
                speed[i] = 0.0  # a limb without its motor hangs, and swings as long as it likes
            self._late = max(self._late, float(speed.max()))
