"""Balance and effort along a trajectory: CoM, ZMP and joint torques.

Of a robot that stands, the CoM's projection has to stay inside the support polygon by the robot's
margin, the ZMP (from the whole body's momentum, Pinocchio's inverse dynamics) inside it by the
checker's. Torques are those of a robot whose soles all press at the same place, seen from each one's own
origin, as the one that carries the motion out has them. A welded base takes any wrench: there, torques are
judged alone.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pinocchio as pin

from kinematics.arrays import Array, Indices
from kinematics.checking.kinematics import BatchedKinematics, BodyPoses
from kinematics.checking.settings import CheckSettings
from kinematics.checking.timeline import Configurations, Timeline
from kinematics.geometry.poses import Transform
from kinematics.model.robot_description import SoleDescription
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import Stance
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.trajectory import Trajectory
from kinematics.motion.verdict import Finding, FindingKind

Loads = Callable[[BodyPoses, Array, Array, Indices, Array, Array], tuple[Array, Array]]
"""Torques and ZMP of a robot on its soles; see ``CompiledKinematics.loads``."""

_FIRST_JOINT = 2


class SupportPolygon:
    """The convex hull of the soles' corners on the floor; frames that are no soles do not carry."""

    def __init__(self, robot: StandingRobot) -> None:
        soles = {sole.frame: sole for sole in robot.model.description.soles}
        corners = [
            (world_T_sole @ np.array([x, y, 0.0, 1.0]))[:2]
            for name, world_T_sole in robot.stance.soles
            if name in soles
            for x in soles[name].x_m
            for y in soles[name].y_m
        ]
        self._edges = _edges(corners) if corners else None

    def margin_m(self, points: Array) -> Array:
        """Distance of points, shape (n, 2), to the nearest edge, positive inside, shape (n,)."""
        if self._edges is None:
            return np.full(len(points), -np.inf)
        normals, offsets = self._edges
        return np.asarray((offsets - points @ normals.T).min(axis=1))


def _edges(corners: list[Array]) -> tuple[Array, Array]:
    """Outward normals, shape (m, 2), and offsets of a convex hull's edges (Andrew's monotone chain)."""
    hull: list[Array] = []
    ordered = sorted(corners, key=lambda corner: (float(corner[0]), float(corner[1])))
    for way in (ordered, ordered[::-1]):
        chain: list[Array] = []
        for corner in way:
            while len(chain) > 1 and _turn(chain[-2], chain[-1], corner) <= 0.0:
                chain.pop()
            chain.append(corner)
        hull += chain[:-1]
    points = np.array(hull)
    along = np.roll(points, -1, axis=0) - points
    normals = np.column_stack([along[:, 1], -along[:, 0]]) / np.linalg.norm(along, axis=1)[:, None]
    return normals, np.einsum("mi,mi->m", normals, points)


def _turn(a: Array, b: Array, c: Array) -> float:
    """Positive when the way a, b, c turns left."""
    return float((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))


class _Standing:
    """What is the same for every motion on one stance.

    Attributes:
        polygon: What its soles span.
        points_m: Places of the m soles that are the robot's, shape (m, 3).
        feet: Bodies that carry them, shape (m,).
        share: Their parts of the wrench of the ground for each ZMP (x, y, 1), held between 0 and 1, shape
            (m, 3).
        height_m: Of the plane that the soles stand on, where the ZMP is.
    """

    def __init__(self, robot: StandingRobot) -> None:
        model, stance = robot.model, robot.stance
        self.height_m = stance.height_m
        self.polygon = SupportPolygon(robot)
        sizes = {sole.frame: sole for sole in model.description.soles}
        carrying = [(sizes[name], pose) for name, pose in stance.soles if name in sizes]
        self.points_m = np.array([pose[:3, 3] for _, pose in carrying]).reshape(-1, 3)
        self.feet = np.array(
            [int(model.pin.frames[model.frame_id(sole.frame)].parentJoint) for sole, _ in carrying], np.int64
        )
        self.share = _shares(carrying, self.points_m[:, :2])


def _shares(carrying: list[tuple[SoleDescription, Transform]], points_m: Array) -> Array:
    """Parts of soles for each ZMP: as far towards a sole as the ZMP is towards the polygon's edge there."""
    count = len(carrying)
    shares = np.tile([0.0, 0.0, 1.0 / max(count, 1)], (count, 1))
    apart = points_m[-1] - points_m[0] if count == 2 else np.zeros(2)
    length = float(np.linalg.norm(apart))
    if length == 0.0:
        return shares
    along = apart / length
    reach = min(_reach(*one, way * along) for one, way in zip(carrying, (-1.0, 1.0), strict=True))
    slope = along / (length + 2.0 * reach)
    for row, way in zip(shares, (-1.0, 1.0), strict=True):
        row[:2] = way * slope
        row[2] = 0.5 - way * float(slope @ points_m.mean(axis=0))
    return shares


def _reach(sole: SoleDescription, world_T_sole: Transform, way: Array) -> float:
    """How far a sole reaches from its origin in a horizontal direction, m."""
    corners = np.array([(x, y) for x in sole.x_m for y in sole.y_m])
    return float((corners @ world_T_sole[:2, :2].T @ way).max())


class DynamicsCheck:
    """Balance and effort of trajectories of one robot."""

    def __init__(
        self,
        model: RobotModel,
        kinematics: BatchedKinematics,
        settings: CheckSettings,
        loads: Loads | None = None,
    ) -> None:
        """Prepare.

        Args:
            model: The robot.
            kinematics: Of the robot.
            settings: Tolerances and fineness.
            loads: Compiled inverse dynamics; Pinocchio's when left out.
        """
        self._model, self._loads = model, loads
        self._kinematics = kinematics
        self._settings = settings
        self._data = model.pin.createData()
        self._armature = np.array(
            [model.description.armature[name] for name in model.joints], dtype=np.float64
        )

    def findings(self, trajectory: Trajectory, timeline: Timeline) -> tuple[list[Finding], float]:
        """Judge balance and effort.

        Returns:
            The findings, and the smallest CoM margin in m; infinite when the base is welded.
        """
        settings = self._settings
        times = timeline.knots(settings.dynamics_period_s)
        configurations = timeline.at(times)
        if self._model.description.welded:
            q = _stacked(configurations)
            return self._effort(times, self._inverse_dynamics(trajectory, times, q)[:, 6:]), np.inf
        placed = self._kinematics.poses(configurations)
        polygon = self._standing(trajectory.stance).polygon
        margin = polygon.margin_m(self._kinematics.com(placed)[:, :2])
        least = self._model.description.com_margin_m
        findings = _first_below("CoM", times, margin, least, least - settings.com_tolerance_m)
        torques, zmp = self._torques_and_zmp(trajectory, configurations, placed)
        zmp_margin = polygon.margin_m(zmp)
        findings += _first_below("ZMP", times, zmp_margin, settings.zmp_margin_m, settings.zmp_margin_m)
        findings += self._effort(times, torques)
        return findings, float(margin.min())

    def _torques_and_zmp(
        self, trajectory: Trajectory, configurations: Configurations, placed: BodyPoses
    ) -> tuple[Array, Array]:
        """Joint torques, shape (n, k), and the ZMP, shape (n, 2)."""
        times = configurations.t_s
        if self._loads is not None:
            standing = self._standing(trajectory.stance)
            rates = self._rates(trajectory, times)
            placed, points = _seen_from(standing.height_m, placed, standing.points_m)
            torques, zmp = self._loads(placed, *rates, standing.feet, points, standing.share)
            torques += rates[1][:, 6:] * self._armature
            return torques, zmp
        q = _stacked(configurations)
        efforts = self._inverse_dynamics(trajectory, times, q)
        force, moment = self._ground_wrench(efforts[:, :6], configurations.base_rotation, q[:, :3])
        lift = np.maximum(force[:, 2], 1e-6)
        height_m = trajectory.stance.height_m
        zmp = np.column_stack([height_m * force[:, 0] - moment[:, 1], height_m * force[:, 1] + moment[:, 0]])
        zmp /= lift[:, None]
        return self._torques(trajectory.stance, efforts, force, moment, zmp, placed), zmp

    def _rates(self, trajectory: Trajectory, times: Array) -> tuple[Array, Array]:
        """Velocities and accelerations, shape (n, nv) each."""
        window = self._settings.acceleration_window_s
        end = trajectory.duration_s
        before, after = np.maximum(times - window, 0.0), np.minimum(times + window, end)
        n = len(times)
        every = _interpolate(trajectory, np.concatenate([times, before, after]))
        v, early, late = every[:n], every[n : 2 * n], every[2 * n :]
        return v, (late - early) / np.maximum(after - before, 1e-9)[:, None]

    def _inverse_dynamics(self, trajectory: Trajectory, times: Array, q: Array) -> Array:
        """Generalised forces without contacts, shape (n, nv); those that turn the rotors are in them."""
        v, a = self._rates(trajectory, times)
        model, data = self._model.pin, self._data
        forces = np.empty((len(times), model.nv))
        for i in range(len(times)):
            forces[i] = pin.rnea(model, data, q[i], v[i], a[i])
        forces[:, 6:] += a[:, 6:] * self._armature
        return forces

    @staticmethod
    def _ground_wrench(base: Array, rotation: Array, position: Array) -> tuple[Array, Array]:
        """Force and moment about the world's origin that the ground has to give."""
        force = np.matmul(rotation, base[:, :3, None])[..., 0]
        moment = np.matmul(rotation, base[:, 3:, None])[..., 0]
        (x, y, z), (fx, fy, fz) = position.T, force.T
        moment += np.column_stack([y * fz - z * fy, z * fx - x * fz, x * fy - y * fx])
        return force, moment

    def _torques(
        self, stance: Stance, efforts: Array, force: Array, moment: Array, zmp: Array, placed: BodyPoses
    ) -> Array:
        """Joint torques when all soles press at the same place of their own."""
        torques = efforts[:, 6:].copy()
        if not stance.soles:
            return torques
        standing = self._standing(stance)
        points = standing.points_m
        parts = np.clip(zmp @ standing.share[:, :2].T + standing.share[:, 2], 0.0, 1.0)
        rest = moment - np.cross(parts @ points, force)
        for k, foot in enumerate(standing.feet.tolist()):
            f, n = parts[:, k, None] * force, parts[:, k, None] * rest
            leg = [body for body in self._kinematics.chain(foot) if body >= _FIRST_JOINT]
            x, y, z = np.moveaxis(points[k] - placed.origin_m[leg], -1, 0)
            fx, fy, fz = f.T
            pull = np.stack([y * fz - z * fy, z * fx - x * fz, x * fy - y * fx], axis=-1) + n
            axis = np.matmul(placed.rotation[leg], self._kinematics.axis[leg][:, None, :, None])[..., 0]
            torques[:, [body - _FIRST_JOINT for body in leg]] -= np.einsum("bni,bni->nb", axis, pull)
        return torques

    def _standing(self, stance: Stance) -> _Standing:
        return StandingRobot.of(self._model, stance).derived(_Standing)

    def _effort(self, times: Array, torques: Array) -> list[Finding]:
        over = np.abs(torques) > self._model.effort
        findings = []
        for joint in np.flatnonzero(over.any(axis=0)):
            bad = np.flatnonzero(over[:, joint])
            value = float(np.abs(torques[bad, joint]).max())
            findings.append(
                Finding(
                    FindingKind.EFFORT_LIMIT,
                    float(times[bad[0]]),
                    (self._model.joints[joint],),
                    value,
                    float(self._model.effort[joint]),
                )
            )
        return findings


def _seen_from(height_m: float, placed: BodyPoses, points_m: Array) -> tuple[BodyPoses, Array]:
    """Bodies and points in a frame whose floor is as high as this in the world."""
    if height_m == 0.0:
        return placed, points_m
    down = np.array([0.0, 0.0, height_m])
    return BodyPoses(placed.rotation, placed.origin_m - down), points_m - down


def _stacked(configurations: Configurations) -> Array:
    """As Pinocchio has them, shape (n, nq)."""
    return np.hstack(
        [configurations.base_position_m, configurations.base_quaternion, configurations.joints_rad]
    )


def _interpolate(trajectory: Trajectory, times: Array) -> Array:
    """Velocities between the samples, shape (n, nv)."""
    t = trajectory.t_s
    i = np.clip(np.searchsorted(t, times, side="right") - 1, 0, len(t) - 2)
    u = ((times - t[i]) / (t[i + 1] - t[i]))[:, None]
    return np.asarray((1.0 - u) * trajectory.v[i] + u * trajectory.v[i + 1])


def _first_below(subject: str, times: Array, values: Array, limit: float, least: float) -> list[Finding]:
    bad = np.flatnonzero(values < least)
    if not len(bad):
        return []
    worst = float(values[bad].min())
    return [Finding(FindingKind.BALANCE, float(times[bad[0]]), (subject,), worst, limit)]
