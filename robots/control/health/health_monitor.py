"""What is wrong with the robot now."""

from __future__ import annotations

from kinematics.model.robot_model import RobotModel
from robots.control.health.arm_resistance import ArmResistance
from robots.control.health.body_health import BodyHealth
from robots.control.health.finding import Ailment, Finding, Response
from robots.control.health.joint_health import JointHealth
from robots.interface.hardware import Hardware, RobotData
from robots.interface.robot import JointSetpoint
from robots.interface.sensed_state import SensedState

_ALARMING = 2
"""So many judgements in a row must find the same before it counts."""
_CLEARED_S = 1.0
"""What was not found for so long is over."""
_STEPPING_ROOM = 4.0
"""Healthy legs at 0.5 m/s miss 11 % of the effort limit for some periods (knee, hip)."""
_STAYS = frozenset({Ailment.STUCK, Ailment.WEAK, Ailment.OFFLINE, Ailment.ENCODER_OFFSET})
"""These show only while something moves or is carried: they stay until a person has looked at the robot."""


class HealthMonitor:
    """Keeps the findings of the judges of health, each from when it is confirmed until it is over.

    Attributes:
        findings: What is wrong now.
    """

    def __init__(self, model: RobotModel, hardware: Hardware, period_s: float) -> None:
        self.findings: dict[tuple[Ailment, str], Finding] = {}
        self._joints = JointHealth(RobotData(model.description, hardware), period_s)
        self._resistance = ArmResistance(model, hardware, period_s)
        self._body = BodyHealth(model, hardware.health, period_s)
        self._counts: dict[tuple[Ailment, str], int] = {}
        self._seen_s: dict[tuple[Ailment, str], float] = {}

    def note_late(self, late_s: float) -> None:
        """Tell by how much the present control period began too late."""
        self._body.note_late(late_s)

    def judge(
        self,
        sensed: SensedState,
        setpoint: JointSetpoint,
        standing: bool,
        in_contact: bool = False,
        stepping: bool = False,
    ) -> tuple[list[Finding], list[Finding]]:
        """Take one period's readings.

        Args:
            sensed: The newest readings.
            setpoint: What the robot followed while they were made.
            standing: Whether both soles are meant to carry.
            in_contact: Whether a hand holds something that may not move.
            stepping: Whether the feet move: efforts change so fast then that averages lag behind.

        Returns:
            What counts from now on, and what is over.
        """
        now_s = sensed.readings.stamp_s
        room = _STEPPING_ROOM if stepping else 1.0
        found = self._of_joints(sensed, setpoint, in_contact, room)
        found += self._body.judge(sensed, standing, stepping, self._joints.bent)
        new = []
        for finding in found:
            key = finding.key
            recent = now_s - self._seen_s.get(key, -1.0) < 0.1
            self._counts[key] = self._counts.get(key, 0) + 1 if recent else 1
            self._seen_s[key] = now_s
            if self._counts[key] >= _ALARMING and key not in self.findings:
                self.findings[key] = finding
                new.append(finding)
        over = [
            finding
            for key, finding in self.findings.items()
            if key[0] not in _STAYS and now_s - self._seen_s[key] > _CLEARED_S
        ]
        for finding in over:
            del self.findings[finding.key]
        return new, over

    def _of_joints(
        self, sensed: SensedState, setpoint: JointSetpoint, in_contact: bool, room: float
    ) -> list[Finding]:
        """What is wrong with joints; one that a pressed hand holds back is not stuck.

        Motors that are damped or taken up do less than their servos' law: nothing is told from them.
        """
        if not sensed.readings.following:
            self._joints.forget()
            self._resistance.forget()
            return []
        resistance = self._resistance
        jammed = resistance.judge(sensed.readings, setpoint, room)
        found = [
            finding
            for finding in self._joints.judge(sensed.readings, setpoint, in_contact, room)
            if finding.ailment is not Ailment.STUCK or not resistance.touched(finding.part, sensed.q)
        ]
        blamed = {finding.part for finding in found}  # a motor that gives too little does not push
        return found + [finding for finding in jammed if not in_contact and finding.part not in blamed]

    def acknowledge(self) -> list[Finding]:
        """A person has looked at the robot: what stayed is over, and will be found again if it is not."""
        self._joints.forget()
        self._resistance.forget()
        self._body.forget()
        over = [finding for key, finding in self.findings.items() if key[0] in _STAYS]
        for finding in over:
            del self.findings[finding.key]
        return over

    def reasons(self, response: Response) -> tuple[str, ...]:
        """For people: what calls for a response now."""
        return tuple(str(finding) for finding in self.findings.values() if finding.response is response)
