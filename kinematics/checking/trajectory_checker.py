"""The judge of planned motions: the only maker of a ``CheckedTrajectory``.

It shares the robot model, the planning scene, the trajectory's definition and the compiled distance of
two solids with the planner and nothing else. Everything is judged over the whole duration, not at the
samples: joint limits in closed form, collisions with a certificate for every interval, the stance wherever
it bends, CoM, ZMP and efforts densely enough for joints that keep their acceleration limit.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from kinematics.arrays import Array
from kinematics.checking.coal_certificate import CollisionCheck
from kinematics.checking.concession_rules import ConcessionJudge
from kinematics.checking.dynamics import DynamicsCheck
from kinematics.checking.kinematics import BatchedKinematics
from kinematics.checking.limits import base_findings, jump_intervals, limit_findings
from kinematics.checking.pairs import PairBuilder, Pairs
from kinematics.checking.rest import rest_findings
from kinematics.checking.settings import DEFAULT_SETTINGS, CheckSettings
from kinematics.checking.stance import stance_findings
from kinematics.checking.timeline import Timeline
from kinematics.compiled import readiness
from kinematics.errors import InvalidMotionError
from kinematics.model.robot_model import RobotModel
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.trajectory import HeldLoad, Trajectory
from kinematics.motion.verdict import CheckedTrajectory, Finding, FindingKind, Unsafe, _Seal
from kinematics.scene.concessions import Concession
from kinematics.scene.planning_scene import PlanningScene

__all__ = ["CheckSettings", "TrajectoryChecker"]

_UNIT_QUATERNION_TOLERANCE = 1e-3


class TrajectoryChecker:
    """Judges trajectories of one robot. Holds working memory: one thread at a time.

    Args:
        model: The robot.
        settings: Tolerances and fineness.
        compiled: Whether to use compiled code, which takes half a minute to make when it is not there;
            Coal gives the same answers, more slowly. When left out: where it is there.

    Raises:
        ModelError: The robot has joints or collision shapes that cannot be judged.
    """

    def __init__(
        self, model: RobotModel, settings: CheckSettings = DEFAULT_SETTINGS, compiled: bool | None = None
    ) -> None:
        self._model = model
        self._settings = settings
        self._finder, self._compiled, loads = None, None, None
        if readiness.usable() if compiled is None else compiled:
            # imported here: they bring the compiler
            from kinematics.checking.compiled_kinematics import CompiledKinematics
            from kinematics.checking.contacts import ContactFinder

            kinematics = CompiledKinematics(model)
            self._kinematics: BatchedKinematics = kinematics
            self._pairs = PairBuilder(model, kinematics)
            self._finder = ContactFinder(kinematics, self._pairs.robot, settings)
            self._compiled, loads = kinematics, kinematics.loads
        else:
            self._kinematics = BatchedKinematics(model)
            self._pairs = PairBuilder(model, self._kinematics)
        self._concessions = ConcessionJudge(model, self._kinematics, self._pairs)
        self._dynamics = DynamicsCheck(model, self._kinematics, settings, loads)
        self._loaded: tuple[tuple[HeldLoad, ...], DynamicsCheck] = ((), self._dynamics)

    def check(
        self, trajectory: Trajectory, scene: PlanningScene, concessions: Sequence[Concession] = ()
    ) -> CheckedTrajectory | Unsafe:
        """Judge one motion in one scene.

        Args:
            trajectory: The motion.
            scene: What is around and in the hands, as the world model has it.
            concessions: What the motion's planner asks to be overlooked. ``check_concessions`` bounds it; a
                concession beyond that is a finding, and its pair is judged by the scene.

        Returns:
            The checked trajectory, or every finding in order of time: one for each kind and subject.

        Raises:
            InvalidMotionError: The trajectory is not one of this robot.
            UnknownNameError: Stance or scene name a frame that the model does not have.
        """
        if trajectory.joints != self._model.joints:
            raise InvalidMotionError(
                f"the joints of the trajectory are not those of {self._model.description.name}"
            )
        model, settings = self._model, self._settings
        timeline = Timeline(trajectory)
        findings = _quaternion_findings(trajectory)
        jumps_s = np.empty((0, 2))
        if self._compiled is None or not self._compiled.keeps_limits(model, timeline, settings):
            findings += limit_findings(model, timeline, settings)
            jumps_s = jump_intervals(model, timeline, settings)
        findings += rest_findings(trajectory)
        findings += base_findings(timeline, trajectory.v[:, 3:6], settings)
        standing = StandingRobot.of(model, trajectory.stance)
        findings += stance_findings(standing, self._kinematics, timeline, settings)
        held = _held_loads(scene)
        loads = tuple(load for load in held if load.mass_kg > 0.0)
        unbalanced, com_margin_m = self._dynamics_with(loads).findings(trajectory, timeline)
        findings += unbalanced
        if concessions:
            pairs, beyond = self._conceded(timeline, scene, concessions)
            findings += beyond
        else:
            pairs = self._pairs.pairs(scene)
        touching, min_distance_m = self._contacts(timeline, pairs, jumps_s)
        findings += touching
        if findings:
            return Unsafe(tuple(sorted(findings, key=lambda finding: finding.t_s)))
        return CheckedTrajectory(
            trajectory=trajectory,
            min_distance_m=min_distance_m,
            min_com_margin_m=com_margin_m,
            seal=_Seal(trajectory),
            loads=loads,
            unweighed=tuple(load for load in held if load.mass_kg == 0.0),
        )

    def _dynamics_with(self, loads: tuple[HeldLoad, ...]) -> DynamicsCheck:
        """Of the robot with what its hands carry; that of the last load is kept."""
        if not loads:
            return self._dynamics
        if self._loaded[0] != loads:
            masses = [(load.frame, load.mass_kg, np.array(load.point_m)) for load in loads]
            if self._compiled is None:
                model = self._model.with_point_masses(masses)
                check = DynamicsCheck(model, BatchedKinematics(model), self._settings)
            else:
                kinematics = self._compiled.carrying(self._model, masses)
                check = DynamicsCheck(self._model, kinematics, self._settings, kinematics.loads)
            self._loaded = loads, check
        return self._loaded[1]

    def _conceded(
        self, timeline: Timeline, scene: PlanningScene, concessions: Sequence[Concession]
    ) -> tuple[Pairs, Sequence[Finding]]:
        """What is judged with the concessions that are within the rules, and those that are not."""
        conceded = self._concessions.judge(timeline, scene, concessions)
        pairs = self._pairs.pairs(conceded.scene)
        return self._concessions.lowered(pairs, conceded.lowered), conceded.findings

    def _contacts(self, timeline: Timeline, pairs: Pairs, jumps_s: Array) -> tuple[list[Finding], float]:
        """Findings and the smallest distance; by Coal alone while nothing is compiled."""
        if self._finder is not None:
            return self._finder.findings(timeline, pairs, jumps_s)
        check = CollisionCheck(self._kinematics, timeline, pairs, self._settings, jumps_s)
        return check.findings(), check.min_distance_m


def _held_loads(scene: PlanningScene) -> tuple[HeldLoad, ...]:
    """What the hands carry: each attached body at its centre, of mass 0 where that is not known."""
    loads = []
    for body in scene.attached.values():
        x, y, z = body.frame_T_object[:3, 3].tolist()
        loads.append(HeldLoad(body.frame, body.mass_kg, (x, y, z)))
    return tuple(loads)


def _quaternion_findings(trajectory: Trajectory) -> list[Finding]:
    """Judge whether every base orientation is a unit quaternion."""
    stray = np.abs(np.linalg.norm(trajectory.q[:, 3:7], axis=1) - 1.0)
    bad = np.flatnonzero(stray > _UNIT_QUATERNION_TOLERANCE)
    if not len(bad):
        return []
    return [
        Finding(
            FindingKind.DISCONTINUITY,
            float(trajectory.t_s[bad[0]]),
            ("base quaternion",),
            float(stray.max()),
            _UNIT_QUATERNION_TOLERANCE,
        )
    ]
