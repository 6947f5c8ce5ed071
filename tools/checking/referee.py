"""A slow judge of trajectories that trusts nothing but dense sampling, Pinocchio and Coal.

It evaluates the definition in ``kinematics.trajectory`` at short steps, and shares no code with
the checker. It is right up to its step: 0.5 ms, and where two solids come near, 0.2 mm.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cache

import coal
import numpy as np
import pinocchio as pin
from numpy.typing import NDArray
from scipy.interpolate import CubicHermiteSpline
from scipy.spatial import ConvexHull

from kinematics.robot_model import RobotModel
from kinematics.scene import PlanningScene, SceneObject
from kinematics.shapes import Ball, Box, Cylinder
from kinematics.trajectory import Trajectory

Array = NDArray[np.float64]

STEP_S = 0.0005
STEP_M = 0.0002
_LOOK_S = 0.02
_NEAR_M = 0.05
"""Pairs farther apart than this at two looks that follow each other are not looked at between: they
would have to close in at 5 m/s."""
_STANCE_STEP_S = 0.004


@dataclass
class Verdict:
    """What the referee found.

    Attributes:
        violations: Kind to (how much beyond what is allowed, who), the worst of each.
        duration_s: Kind to the length of time during which it is violated.
        least_distance_m: Smallest distance of a judged pair beyond the margin that it has to keep.
        com_margin_m, zmp_margin_m: Smallest distances to the edge of the support polygon.
    """

    violations: dict[str, tuple[float, str]] = field(default_factory=dict)
    duration_s: dict[str, float] = field(default_factory=dict)
    least_distance_m: float = np.inf
    com_margin_m: float = np.inf
    zmp_margin_m: float = np.inf

    @property
    def unsafe(self) -> bool:
        """Whether anything is violated."""
        return bool(self.violations)

    def add(self, kind: str, excess: float, who: str, duration_s: float = 0.0) -> None:
        """Keep the worst violation of a kind, and the longest time."""
        if kind not in self.violations or excess > self.violations[kind][0]:
            self.violations[kind] = (excess, who)
        self.duration_s[kind] = max(duration_s, self.duration_s.get(kind, 0.0))


class Referee:
    """Judges trajectories of one robot."""

    def __init__(self, model: RobotModel) -> None:
        self.model = model
        self._data = model.pin.createData()

    def judge_alone(self, trajectory: Trajectory) -> Verdict:
        """Judge limits, stance and balance: what needs no scene."""
        verdict = Verdict()
        self._limits(trajectory, verdict)
        self._stance_and_balance(trajectory, verdict)
        return verdict

    def judge(self, trajectory: Trajectory, scene: PlanningScene, alone: Verdict | None = None) -> Verdict:
        """Judge everything that can be violated; ``alone`` is what ``judge_alone`` said before."""
        verdict = alone or self.judge_alone(trajectory)
        self._collisions(trajectory, scene, verdict)
        return verdict

    def _limits(self, trajectory: Trajectory, verdict: Verdict) -> None:
        t, h = trajectory.t_s, np.diff(trajectory.t_s)
        q, v = trajectory.q[:, 7:], trajectory.v[:, 6:]
        spline = CubicHermiteSpline(t, q, v)
        u = np.linspace(0.0, 1.0, 13)[1:-1]
        inside = np.sort(np.concatenate([t, (t[:-1, None] + h[:, None] * u).ravel()]))
        position, speed = spline(inside), np.abs(spline(inside, 1))
        just_after, just_before = spline(t[:-1], 2), spline(t[1:] - 1e-9 * h, 2)
        acceleration = np.maximum(np.abs(just_after), np.abs(just_before))
        jerk = np.abs(spline(0.5 * (t[1:] + t[:-1]), 3))
        step = np.abs(just_after[1:] - just_before[:-1]) / (0.5 * (h[1:] + h[:-1]))[:, None]
        model = self.model
        outside = np.maximum(model.lower_rad - position, position - model.upper_rad)
        # the range is what one percent of a position limit is a percent of
        self._over(verdict, "position", outside, 0.0, inside)
        self._over(verdict, "velocity", speed / model.velocity, 1.0, inside)
        self._over(verdict, "acceleration", acceleration / model.acceleration, 1.0, t[:-1])
        self._over(verdict, "jerk", jerk / model.jerk, 1.0, t[:-1])
        if len(step):
            spread = (
                np.abs(np.diff(np.diff(v, axis=0) / h[:, None], axis=0)) / (0.5 * (h[1:] + h[:-1]))[:, None]
            )
            self._over(verdict, "jerk", np.maximum(step, spread) / model.jerk, 1.0, t[1:-1])

    def _over(self, verdict: Verdict, kind: str, value: Array, limit: float, times: Array) -> None:
        excess = value - limit
        bad = (excess > 1e-6).any(axis=1)
        if not bad.any():
            return
        joint = int(np.argmax(excess.max(axis=0)))
        verdict.add(kind, float(excess.max()), self.model.joints[joint], float(np.ptp(times[bad])))

    def configurations(self, trajectory: Trajectory, times: Array) -> Array:
        """The definition of ``Trajectory`` between its samples, shape (n, nq)."""
        return _Definition(trajectory)(times)

    def com_margin_m(self, trajectory: Trajectory) -> float:
        """Smallest distance of the CoM to the edge of the support polygon, at the samples alone."""
        hull = self._hull(trajectory)
        coms = np.array([pin.centerOfMass(self.model.pin, self._data, q)[:2] for q in trajectory.q])
        return float(-(coms @ hull[:, :2].T + hull[:, 2]).max())

    def _hull(self, trajectory: Trajectory) -> Array:
        soles = {sole.frame: sole for sole in self.model.description.soles}
        corners = [
            (pose @ [x, y, 0, 1])[:2]
            for name, pose in trajectory.stance.soles
            for x in soles[name].x_m
            for y in soles[name].y_m
        ]
        return np.asarray(ConvexHull(np.array(corners)).equations)

    def _stance_and_balance(self, trajectory: Trajectory, verdict: Verdict) -> None:
        model, data, robot = self.model.pin, self._data, self.model
        times = np.union1d(np.arange(0.0, trajectory.duration_s, _STANCE_STEP_S), trajectory.t_s)
        rows = self.configurations(trajectory, times)
        hull = self._hull(trajectory)
        feet = [(robot.frame_id(name), name, pin.SE3(pose)) for name, pose in trajectory.stance.soles]
        margins = np.empty(len(times))
        for i, q in enumerate(rows):
            com = pin.centerOfMass(model, data, q)
            margins[i] = -(hull[:, :2] @ com[:2] + hull[:, 2]).max()
            pin.updateFramePlacements(model, data)
            for frame, name, target in feet:
                apart = target.actInv(data.oMf[frame])
                slip = float(np.linalg.norm(apart.translation))
                tilt = float(np.linalg.norm(pin.log3(apart.rotation)))
                if slip > 0.001 or tilt > 0.002:
                    verdict.add("stance", max(slip, tilt), name)
        verdict.com_margin_m = float(margins.min())
        missing = robot.description.com_margin_m - margins
        if missing.max() > 1e-6:
            verdict.add("balance", float(missing.max()), "CoM", float(np.ptp(times[missing > 0.0])))
        self._tipping(trajectory, hull, verdict)

    def _tipping(self, trajectory: Trajectory, hull: Array, verdict: Verdict) -> None:
        """ZMP from the change of the centroidal momentum, by differences of momenta."""
        model, data = self.model.pin, self._data
        end = trajectory.duration_s
        times = np.asarray(np.arange(0.0, end, 0.01), dtype=np.float64)
        t = trajectory.t_s

        def momentum(at: Array) -> tuple[Array, Array]:
            rows = self.configurations(trajectory, at)
            twists = np.stack([np.interp(at, t, column) for column in trajectory.v.T], axis=1)
            values, coms = [], []
            for q, v in zip(rows, twists, strict=True):
                values.append(pin.computeCentroidalMomentum(model, data, q, v).vector.copy())
                coms.append(data.com[0].copy())
            return np.array(values), np.array(coms)

        before, after = np.maximum(times - 0.01, 0.0), np.minimum(times + 0.01, end)
        first, _ = momentum(before)
        last, _ = momentum(after)
        _, com = momentum(times)
        change = (last - first) / (after - before)[:, None]
        lift = change[:, 2] + self.model.mass_kg * 9.81
        x = com[:, 0] - (com[:, 2] * change[:, 0] + change[:, 4]) / lift
        y = com[:, 1] - (com[:, 2] * change[:, 1] - change[:, 3]) / lift
        margin = -(np.column_stack([x, y]) @ hull[:, :2].T + hull[:, 2]).max(axis=1)
        verdict.zmp_margin_m = float(margin.min())
        if margin.min() < 0.0:
            verdict.add("tipping", float(-margin.min()), "ZMP", float(np.ptp(times[margin < 0.0])))

    def _collisions(self, trajectory: Trajectory, scene: PlanningScene, verdict: Verdict) -> None:
        world, motion = CollisionWorld(self.model, scene), _Definition(trajectory)
        looks = np.append(np.arange(0.0, trajectory.duration_s, _LOOK_S), trajectory.duration_s)
        rows = motion(looks)
        moving = world.moving_pairs(trajectory)
        gaps = np.full((len(looks), len(world.names)), np.inf)
        gaps[0] = world.distances(rows[0]) - world.margins
        for k in range(1, len(looks)):
            gaps[k, moving] = world.distances(rows[k], moving) - world.margins[moving]
        touching: dict[int, list[float]] = {}
        for pair in np.flatnonzero(gaps[0] <= 0.0):
            self._touch(world, verdict, touching, int(pair), float(gaps[0, pair]), 0.0)
        near = np.minimum(gaps[:-1], gaps[1:]) < _NEAR_M
        for window in np.flatnonzero(near[:, moving].any(axis=1)):
            pairs = moving[near[window, moving]]
            start, end = looks[window], looks[window + 1]
            times = np.linspace(start, end, int(np.ceil((end - start) / STEP_S)) + 1)
            steps = motion(times)
            least = np.array([world.distances(q, pairs) for q in steps]) - world.margins[pairs]
            for k, column in np.argwhere(least <= 0.0):
                pair, gap = int(pairs[column]), float(least[k, column])
                self._touch(world, verdict, touching, pair, gap, float(times[k]))
            for k in range(len(times) - 1):
                # what could touch between these two steps, with points two metres from every joint
                moved = np.abs(steps[k + 1] - steps[k]).sum()
                close = (least[k] > 0.0) & (least[k + 1] > 0.0) & (least[k] + least[k + 1] < 2.0 * moved)
                if not close.any():
                    continue
                fine = np.linspace(times[k], times[k + 1], int(np.clip(moved / STEP_M, 1, 50)) + 1)
                for t_s, q in zip(fine, motion(fine), strict=True):
                    found = world.distances(q, pairs[close]) - world.margins[pairs[close]]
                    verdict.least_distance_m = min(verdict.least_distance_m, float(found.min()))
                    for pair, gap in zip(pairs[close], found, strict=True):
                        if gap <= 0.0:
                            self._touch(world, verdict, touching, int(pair), float(gap), float(t_s))
            verdict.least_distance_m = min(verdict.least_distance_m, float(least.min()))
        for pair, contact in touching.items():
            kind = world.kinds[pair]
            verdict.duration_s[kind] = max(verdict.duration_s[kind], max(contact) - min(contact))

    @staticmethod
    def _touch(
        world: CollisionWorld,
        verdict: Verdict,
        touching: dict[int, list[float]],
        pair: int,
        gap: float,
        t_s: float,
    ) -> None:
        if gap == 0.0 and world.margins[pair] > 0.0:
            return
        touching.setdefault(pair, []).append(t_s)
        verdict.add(world.kinds[pair], -gap, " and ".join(world.names[pair]))


class _Definition:
    """What ``Trajectory`` says about any time."""

    def __init__(self, trajectory: Trajectory) -> None:
        t, q, v = trajectory.t_s, trajectory.q, trajectory.v
        world = [pin.XYZQUATToSE3(row[:7]).rotation @ twist[:3] for row, twist in zip(q, v, strict=True)]
        self._base = CubicHermiteSpline(t, q[:, :3], np.array(world))
        self._joints = CubicHermiteSpline(t, q[:, 7:], v[:, 6:])
        self._t, self._quaternion = t, q[:, 3:7].copy()
        for i in range(1, len(t)):
            if self._quaternion[i] @ self._quaternion[i - 1] < 0.0:
                self._quaternion[i] *= -1.0

    def __call__(self, times: Array) -> Array:
        blend = np.stack([np.interp(times, self._t, column) for column in self._quaternion.T], axis=1)
        blend /= np.linalg.norm(blend, axis=1, keepdims=True)
        return np.hstack([self._base(times), blend, self._joints(times)])


@cache
def _pristine_hulls(model: RobotModel) -> pin.GeometryModel:
    """The robot's links as hulls of their meshes, made here and not by the product."""
    geometry = pin.buildGeomFromUrdfString(
        model.pin, model.description.planning_urdf, pin.GeometryType.COLLISION
    )
    for item in geometry.geometryObjects:
        if isinstance(item.geometry, coal.BVHModelBase):
            item.geometry.buildConvexHull(True, "Qt")
            item.geometry = item.geometry.convex
    for pair in model.geometry().collisionPairs:
        geometry.addCollisionPair(pair)
    return geometry


def _hulls(model: RobotModel) -> pin.GeometryModel:
    return _pristine_hulls(model).copy()


class CollisionWorld:
    """Robot, held objects and scene in one Pinocchio geometry model.

    Attributes:
        names: Of each judged pair.
        kinds: "self", "scene" or "held", of each pair.
        margins: Distance that each pair has to keep, shape (p,).
    """

    def __init__(self, model: RobotModel, scene: PlanningScene, only: frozenset[str] | None = None) -> None:
        self._model = model
        self.geometry = _hulls(model)
        links = [model.link_of(item) for item in self.geometry.geometryObjects]
        own = [(pair.first, pair.second) for pair in self.geometry.collisionPairs]
        self.geometry.removeAllCollisionPairs()
        owner, role = list(links), ["robot"] * len(links)
        touch: dict[int, frozenset[str]] = {}
        for body in scene.attached.values():
            frame = model.pin.frames[model.frame_id(body.frame)]
            place = frame.placement * pin.SE3(body.frame_T_object)
            index = self._add(body.body, int(frame.parentJoint), place)
            owner.append(body.body.name)
            role.append("held")
            touch[index] = body.touch_links
        margin = {}
        for item in scene.objects.values():
            index = self._add(item, 0, pin.SE3(item.world_T_object))
            owner.append(item.name)
            role.append("scene")
            margin[index] = item.margin_m
        self.names: list[tuple[str, str]] = []
        self.kinds: list[str] = []
        margins: list[float] = []
        pairs = [] if only is not None else list(own)
        for i in range(len(links), len(owner)):
            for j in range(i):
                if role[i] == role[j] == "scene" or (only is not None and owner[i] not in only):
                    continue
                if role[i] == "held" and owner[j] in touch[i]:
                    continue
                pairs.append((j, i))
        for j, i in pairs:
            if scene.is_allowed(owner[j], owner[i]):
                continue
            self.geometry.addCollisionPair(pin.CollisionPair(j, i))
            self.names.append((owner[j], owner[i]))
            roles = {role[i], role[j]}
            self.kinds.append("held" if "held" in roles else "scene" if "scene" in roles else "self")
            margins.append(margin.get(i, 0.0))
        self.margins = np.array(margins)
        self._data = model.pin.createData()
        self._placed = self.geometry.createData()

    def moving_pairs(self, trajectory: Trajectory) -> NDArray[np.intp]:
        """Pairs that a trajectory moves relative to each other."""
        tree = self._model.pin
        still = {
            k + 2
            for k in range(len(trajectory.joints))
            if not np.ptp(trajectory.q[:, 7 + k]) and not trajectory.v[:, 6 + k].any()
        }
        if not np.ptp(trajectory.q[:, :7], axis=0).any() and not trajectory.v[:, :6].any():
            still.add(1)
        items = self.geometry.geometryObjects
        above = [set(tree.supports[item.parentJoint]) if item.parentJoint else set() for item in items]
        return np.array(
            [
                k
                for k, pair in enumerate(self.geometry.collisionPairs)
                if ((above[pair.first] ^ above[pair.second]) - {0}) - still
            ],
            dtype=np.intp,
        )

    def move(self, name: str, world_T_object: Array) -> None:
        """Put a scene object elsewhere."""
        index = self.geometry.getGeometryId(name)
        self.geometry.geometryObjects[index].placement = pin.SE3(world_T_object)

    def distances(self, q: Array, pairs: NDArray[np.intp] | None = None) -> Array:
        """Signed distances of all pairs, or of some, at one configuration."""
        pin.updateGeometryPlacements(self._model.pin, self._data, self.geometry, self._placed, q)
        which = range(len(self.names)) if pairs is None else pairs
        compute, geometry, placed = pin.computeDistance, self.geometry, self._placed
        return np.array([compute(geometry, placed, int(k)).min_distance for k in which])

    def _add(self, item: SceneObject, joint: int, place: pin.SE3) -> int:
        shape = item.shape
        if isinstance(shape, Box):
            solid = coal.Box(*shape.size_m)
        elif isinstance(shape, Cylinder):
            solid = coal.Cylinder(shape.radius_m, shape.height_m)
        elif isinstance(shape, Ball):
            solid = coal.Sphere(shape.radius_m)
        return int(self.geometry.addGeometryObject(pin.GeometryObject(item.name, joint, place, solid)))
