"""Whether the feet stay where the stance says they stand, and a welded base where it is mounted."""

from __future__ import annotations

import numpy as np

from kinematics.arrays import Array
from kinematics.checking.kinematics import BatchedKinematics
from kinematics.checking.settings import CheckSettings
from kinematics.checking.timeline import Timeline
from kinematics.model.robot_model import RobotModel
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.verdict import Finding, FindingKind

# a foot hangs about a metre below the base: a bend of this many radians moves it as many metres
_LEG_M = 1.0


def stance_findings(
    robot: StandingRobot,
    kinematics: BatchedKinematics,
    timeline: Timeline,
    settings: CheckSettings,
) -> list[Finding]:
    """Judge every sole of the stance at every sample, and between them where the motion bends.

    A welded base is judged as well: it may not move at all.

    Raises:
        UnknownNameError: The stance names a frame that the model does not have.
    """
    model, stance = robot.model, robot.stance
    findings = _mount_findings(model, timeline, settings) if model.description.welded else []
    if not stance.soles:
        return findings
    frames = [model.pin.frames[model.frame_id(name)] for name, _ in stance.soles]
    feet = frozenset(int(frame.parentJoint) for frame in frames)
    legs = sorted({body - 2 for foot in feet for body in kinematics.chain(foot) if body >= 2})
    configurations = timeline.at(_instants(timeline, legs, settings))
    placed = kinematics.poses(configurations, feet)
    for (name, world_T_sole), frame in zip(stance.soles, frames, strict=True):
        body, local = int(frame.parentJoint), np.array(frame.placement.homogeneous)
        position = placed.rotation[body] @ local[:3, 3] + placed.origin_m[body]
        slip = np.linalg.norm(position - world_T_sole[:3, 3], axis=1)
        # Frobenius distance of two rotations is 2 sqrt(2) sin(angle / 2)
        apart = placed.rotation[body] @ local[:3, :3] - world_T_sole[:3, :3]
        sine = np.linalg.norm(apart.reshape(-1, 9), axis=1) / (2.0 * np.sqrt(2.0))
        tilt = 2.0 * np.arcsin(np.minimum(sine, 1.0))
        for subject, value, limit in (
            ((name,), slip, settings.stance_m),
            ((name, "orientation"), tilt, settings.stance_rad),
        ):
            bad = np.flatnonzero(value > limit)
            if len(bad):
                t_s = float(configurations.t_s[bad[0]])
                findings.append(Finding(FindingKind.STANCE, t_s, subject, float(value[bad].max()), limit))
    return findings


def _mount_findings(model: RobotModel, timeline: Timeline, settings: CheckSettings) -> list[Finding]:
    """Judge a welded base against its mount, between the samples too."""
    between = timeline.bend()[:, 0]
    stray = np.linalg.norm(timeline.base_position_m - model.mount[:3, 3], axis=1)
    stray += np.maximum(np.append(between, 0.0), np.append(0.0, between))
    # the base's orientation is blended: it strays nowhere farther than at a sample
    mount = np.array(model.q_home[3:7])
    cosine = np.abs(timeline.quaternions @ mount) / np.linalg.norm(mount)
    tilt = 2.0 * np.arccos(np.minimum(cosine, 1.0))
    base, findings = model.description.base_link, []
    for subject, value, limit in (
        ((base,), stray, settings.stance_m),
        ((base, "orientation"), tilt, settings.stance_rad),
    ):
        bad = np.flatnonzero(value > limit)
        if len(bad):
            t_s = float(timeline.t_s[bad[0]])
            findings.append(Finding(FindingKind.STANCE, t_s, subject, float(value[bad].max()), limit))
    return findings


def _instants(timeline: Timeline, legs: list[int], settings: CheckSettings) -> Array:
    """Samples, and more between them where base or legs bend by more than a part of the tolerance."""
    if timeline.rests(legs):
        return timeline.t_s[:1]
    bend = timeline.bend(legs)
    stray = bend[:, 0] + _LEG_M * bend[:, 1:].sum(axis=1)
    parts = np.ceil(np.sqrt(stray / (0.25 * settings.stance_m))).astype(np.intp)
    extra = [
        np.linspace(timeline.t_s[i], timeline.t_s[i + 1], min(int(parts[i]), 200) + 1)[1:-1]
        for i in np.flatnonzero(parts > 1)
    ]
    return np.union1d(timeline.t_s, np.concatenate(extra)) if extra else timeline.t_s
