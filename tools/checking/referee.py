"""A slow judge of trajectories that trusts nothing but dense sampling, Pinocchio and Coal.

It evaluates the definition in ``kinematics.motion.trajectory`` at short steps, and shares no code with
the checker. It is right up to its step: 0.5 ms, and where two solids come near, 0.2 mm.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
import pinocchio as pin
from scipy.interpolate import CubicHermiteSpline
from scipy.spatial import ConvexHull
from scipy.spatial.transform import Rotation

from kinematics.arrays import Array
from kinematics.collision.collision_world import with_floor
from kinematics.model.robot_model import RobotModel
from kinematics.motion.trajectory import Trajectory
from kinematics.scene.planning_scene import PlanningScene
from tools.checking.contact_search import ContactSearch
from tools.checking.solid_world import SolidWorld

_STANCE_STEP_S = 0.004
_TIPPING_STEP_S = 0.01


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
        self._massive = model.pin
        self._data = model.pin.createData()
        self._defined: tuple[Trajectory, Definition] | None = None

    def judge_alone(self, trajectory: Trajectory) -> Verdict:
        """Judge limits, stance and balance with empty hands: what needs no scene."""
        return self._judge_alone(trajectory, PlanningScene())

    def _judge_alone(self, trajectory: Trajectory, scene: PlanningScene) -> Verdict:
        verdict = Verdict()
        self._limits(trajectory, verdict)
        self._massive = self._with_masses(scene)
        self._data = self._massive.createData()
        if self.model.description.welded:
            self._mount(trajectory, verdict)
        else:
            self._stance_and_balance(trajectory, verdict)
        return verdict

    def _with_masses(self, scene: PlanningScene) -> pin.Model:
        """The robot with a body of its own for each mass that hangs on a hand."""
        model = pin.Model(self.model.pin)
        for name, held in scene.attached.items():
            if held.mass_kg > 0.0:
                frame = model.frames[model.getFrameId(held.frame)]
                place = frame.placement * pin.SE3(held.frame_T_object)
                grip = pin.Frame(name, frame.parentJoint, place, pin.FrameType.BODY)
                grip.inertia = pin.Inertia(held.mass_kg, np.zeros(3), np.zeros((3, 3)))
                model.addFrame(grip)
        return model

    def judge(self, trajectory: Trajectory, scene: PlanningScene, alone: Verdict | None = None) -> Verdict:
        """Judge everything that can be violated.

        Args:
            trajectory: The motion.
            scene: What is around, and what the hands hold; its masses count in the balance.
            alone: What ``judge_alone`` said before; of no use when a hand holds a mass.
        """
        if alone is None or any(held.mass_kg > 0.0 for held in scene.attached.values()):
            alone = self._judge_alone(trajectory, scene)
        verdict = alone
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
        return self._definition(trajectory)(times)

    def _definition(self, trajectory: Trajectory) -> Definition:
        if self._defined is None or self._defined[0] is not trajectory:
            self._defined = trajectory, Definition(trajectory)
        return self._defined[1]

    def com_margin_m(self, trajectory: Trajectory) -> float:
        """Smallest distance of the CoM to the edge of the support polygon, at samples, with empty hands."""
        hull = self._hull(trajectory)
        data = self.model.pin.createData()
        coms = np.array([pin.centerOfMass(self.model.pin, data, q)[:2] for q in trajectory.q])
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
        model, data, robot = self._massive, self._data, self.model
        times = np.union1d(np.arange(0.0, trajectory.duration_s, _STANCE_STEP_S), trajectory.t_s)
        rows = self.configurations(trajectory, times)
        hull = self._hull(trajectory)
        feet = [(robot.frame_id(name), name, pin.SE3(pose)) for name, pose in trajectory.stance.soles]
        coms, apart = np.empty((len(times), 2)), np.empty((len(feet), len(times), 4, 4))
        inverses = [target.inverse() for _, _, target in feet]
        for i, q in enumerate(rows):
            coms[i] = pin.centerOfMass(model, data, q)[:2]
            for k, (frame, _, _) in enumerate(feet):
                apart[k, i] = (inverses[k] * pin.updateFramePlacement(model, data, frame)).homogeneous
        margins = -(coms @ hull[:, :2].T + hull[:, 2]).max(axis=1)
        for (_, name, _), poses in zip(feet, apart, strict=True):
            slip = np.linalg.norm(poses[:, :3, 3], axis=1)
            tilt = Rotation.from_matrix(poses[:, :3, :3]).magnitude()
            strays = (slip > 0.001) | (tilt > 0.002)
            if strays.any():
                verdict.add("stance", float(np.maximum(slip, tilt)[strays].max()), name)
        verdict.com_margin_m = float(margins.min())
        missing = robot.description.com_margin_m - margins
        if missing.max() > 1e-6:
            verdict.add("balance", float(missing.max()), "CoM", float(np.ptp(times[missing > 0.0])))
        self._tipping(trajectory, hull, verdict)

    def _mount(self, trajectory: Trajectory, verdict: Verdict) -> None:
        """A welded base may not move at all."""
        times = np.union1d(np.arange(0.0, trajectory.duration_s, _STANCE_STEP_S), trajectory.t_s)
        base, home = self.configurations(trajectory, times)[:, :7], self.model.q_home[:7]
        slip = np.linalg.norm(base[:, :3] - home[:3], axis=1)
        tilt = (Rotation.from_quat(base[:, 3:]) * Rotation.from_quat(home[3:]).inv()).magnitude()
        strays = (slip > 0.001) | (tilt > 0.002)
        if strays.any():
            name = self.model.description.base_link
            verdict.add("stance", float(np.maximum(slip, tilt)[strays].max()), name)

    def _tipping(self, trajectory: Trajectory, hull: Array, verdict: Verdict) -> None:
        """ZMP from the change of the centroidal momentum, by differences of momenta."""
        model, data = self._massive, self._data
        end, t = trajectory.duration_s, trajectory.t_s
        times = np.append(np.arange(0.0, end, _TIPPING_STEP_S), end)
        rows = self.configurations(trajectory, times)
        twists = np.stack([np.interp(times, t, column) for column in trajectory.v.T], axis=1)
        momenta, com = np.empty((len(times), 6)), np.empty((len(times), 3))
        for i, (q, v) in enumerate(zip(rows, twists, strict=True)):
            momenta[i] = pin.computeCentroidalMomentum(model, data, q, v).vector
            com[i] = data.com[0]
        # from the instant before to the one after, which the end has not
        after, com = np.arange(1, len(times)), com[:-1]
        before = np.maximum(after - 2, 0)
        change = (momenta[after] - momenta[before]) / (times[after] - times[before])[:, None]
        lift = change[:, 2] + float(pin.computeTotalMass(model)) * 9.81
        # the ZMP is on the plane that the soles stand on
        height = com[:, 2] - np.mean([pose[2, 3] for _, pose in trajectory.stance.soles])
        x = com[:, 0] - (height * change[:, 0] + change[:, 4]) / lift
        y = com[:, 1] - (height * change[:, 1] - change[:, 3]) / lift
        margin = -(np.column_stack([x, y]) @ hull[:, :2].T + hull[:, 2]).max(axis=1)
        verdict.zmp_margin_m = float(margin.min())
        if margin.min() < 0.0:
            verdict.add("tipping", float(-margin.min()), "ZMP", float(np.ptp(times[:-1][margin < 0.0])))

    def _collisions(self, trajectory: Trajectory, scene: PlanningScene, verdict: Verdict) -> None:
        if self.model.description.welded:  # an arm on a table may reach into the floor
            scene = with_floor(self.model, scene)
        world = SolidWorld(self.model, scene)
        search = ContactSearch(self.model, world, self._definition(trajectory), trajectory.duration_s)
        verdict.least_distance_m = search.least_m
        for pair, contact in search.contacts.items():
            lasted_s = contact.last_s - contact.first_s
            verdict.add(world.kinds[pair], contact.depth_m, " and ".join(world.names[pair]), lasted_s)


class Definition:
    """A trajectory between its samples."""

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
        """Configurations, shape (n, nq), by time, shape (n,)."""
        blend = np.stack([np.interp(times, self._t, column) for column in self._quaternion.T], axis=1)
        blend /= np.linalg.norm(blend, axis=1, keepdims=True)
        return np.hstack([self._base(times), blend, self._joints(times)])
