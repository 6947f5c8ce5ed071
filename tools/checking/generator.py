"""Random trajectories of a robot, sound ones and ones with one planted defect."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from kinematics.checking.settings import DEFAULT_SETTINGS
from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball, Box, Cylinder, Shape
from kinematics.model.robot_model import RobotModel
from kinematics.motion.trajectory import Trajectory
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from tools.checking.motions import (
    Choreographer,
    Motion,
    UnfitMotionError,
    quaternion_product,
    random_motion,
    sample_times,
)
from tools.checking.placing import Placer, random_rotation, random_thing, shape_of_parts
from tools.checking.profiles import Profile
from tools.checking.referee import Referee, Verdict
from tools.checking.solid_world import SolidWorld

Kind = Literal["sound", "limit", "self", "scene", "held", "balance", "jump", "thin", "brief"]
DEFECTS: tuple[Kind, ...] = ("limit", "self", "scene", "held", "balance", "jump", "thin", "brief")

_EXPECTED: dict[Kind, set[str]] = {
    "limit": {"position", "velocity", "acceleration", "jerk"},
    "self": {"self"},
    "scene": {"scene"},
    "held": {"held"},
    "balance": {"balance", "tipping"},
    "jump": {"position", "velocity", "acceleration", "jerk", "stance"},
    "thin": {"scene"},
    "brief": {"scene"},
}
_NEEDS_NO_SCENE = ("limit", "balance", "jump")
_TRIES = 300
_LARGEST_M = 0.1
_THIN_RADIUS_M = 0.0005
HELD_KG = 1.0
"""What a held thing weighs: a full bottle."""
_BRIEF_S = 0.01
"""A brief defect lasts less than this."""
_DECLARED_M = DEFAULT_SETTINGS.spare_m + 2.0 * DEFAULT_SETTINGS.collision_m
"""What the checker declares that it needs beyond every margin, to certify it: a motion that passes by
something with less than these hundredths of a millimetre is neither sound nor a defect: drawn again."""


@dataclass(frozen=True)
class Case:
    """One trajectory with what is known about it.

    Attributes:
        kind: What was planted.
        size_m: How large: m, rad, or the fraction over a limit.
        verdict: The referee's.
    """

    kind: Kind
    size: float
    trajectory: Trajectory
    scene: PlanningScene
    verdict: Verdict


class Generator:
    """Makes cases for one robot; the referee confirms each.

    Args:
        model: The robot.
        longest_s: Motions that take longer are not used.
        smallest_m: Defects are log-uniform from this to 0.1 (m, rad; a tenth of it over a limit).
        parts: Whether things are of convex parts, as what is made of meshes is.

    Attributes:
        defects: What can be planted in a motion of this robot: what is bolted down cannot tip.
    """

    def __init__(
        self, model: RobotModel, longest_s: float = 20.0, smallest_m: float = 0.001, parts: bool = False
    ) -> None:
        self._parts = parts
        self._model = model
        self._hands, tips = model.description.gripping_hands, not model.description.welded
        self.defects = tuple(kind for kind in DEFECTS if tips or kind != "balance")
        self._arms = [f"{hand}_arm" for hand in self._hands]
        self._limbs = [*self._arms, *(["head"] if len(model.group("head")) else [])]
        self._longest_s = longest_s
        self._smallest_m = smallest_m
        self._choreographer = Choreographer(model)
        self._placer = Placer(model)
        self._referee = Referee(model)
        self._judged: tuple[Trajectory, Verdict] | None = None

    def case(self, kind: Kind, rng: np.random.Generator) -> Case:
        """Draw until the referee agrees that the case is what it should be.

        Raises:
            RuntimeError: No such case was found in many tries.
        """
        for _ in range(_TRIES):
            size = float(np.exp(rng.uniform(np.log(self._smallest_m), np.log(_LARGEST_M))))
            try:
                made = getattr(self, f"_{kind}")(rng, size)
            except UnfitMotionError:
                continue
            if made is None:
                continue
            trajectory, scene, size = made
            verdict = self._alone(trajectory)
            heavy = any(held.mass_kg > 0.0 for held in scene.attached.values())
            if heavy or (kind not in _NEEDS_NO_SCENE and not (kind == "sound" and verdict.unsafe)):
                verdict = self._referee.judge(trajectory, scene, verdict)
            wanted = (
                not verdict.unsafe and verdict.least_distance_m >= _DECLARED_M
                if kind == "sound"
                else bool(_EXPECTED[kind] & set(verdict.violations))
            )
            if kind == "brief":
                wanted = wanted and verdict.duration_s["scene"] < _BRIEF_S
            if wanted:
                return Case(kind, size, trajectory, scene, verdict)
        raise RuntimeError(f"no case of kind {kind!r} in {_TRIES} tries")

    def _alone(self, trajectory: Trajectory) -> Verdict:
        """What the referee says without a scene: asked before something is placed, and once more after."""
        if self._judged is None or self._judged[0] is not trajectory:
            self._judged = trajectory, self._referee.judge_alone(trajectory)
        return self._judged[1]

    def _timed(self, rng: np.random.Generator, motion: Motion) -> Trajectory:
        return self._with_use(rng, motion, rng.uniform(0.35, 0.97))

    def _with_use(self, rng: np.random.Generator, motion: Motion, use: float) -> Trajectory:
        """Time a motion so that its most demanding limit is used to the fraction ``use``."""
        duration = self._choreographer.duration(motion, use)
        if duration > self._longest_s:
            raise UnfitMotionError
        return self._choreographer.trajectory(motion, duration, sample_times(rng, duration))

    def _sound(self, rng: np.random.Generator, _: float) -> tuple[Trajectory, PlanningScene, float] | None:
        trajectory = self._timed(rng, random_motion(self._model, rng))
        if self._alone(trajectory).unsafe:
            return None
        return trajectory, self._surroundings(rng, trajectory), 0.0

    def _surroundings(
        self, rng: np.random.Generator, trajectory: Trajectory, scene: PlanningScene | None = None
    ) -> PlanningScene:
        """A table, objects at gaps of 1 mm to 0.3 m from the motion, sometimes something held."""
        scene = scene or PlanningScene()
        if not scene.attached and rng.random() < 0.4:
            scene = self._holding(rng, scene)
        for i in range(int(rng.integers(0, 4))):
            gap = float(np.exp(rng.uniform(np.log(0.001), np.log(0.3))))
            item = self._random_object(rng, f"thing {i}")
            placed = self._placer.place(rng, trajectory, scene, item, gap)
            if placed is not None:
                scene = scene.with_object(placed)
        if rng.random() < 0.5:
            table = SceneObject(
                "table",
                Box((0.6, 1.2, 0.04)),
                poses.translation(rng.uniform(0.75, 0.95), 0.0, rng.uniform(0.5, 0.8)),
                margin_m=float(rng.choice([0.0, 0.01])),
                movable=False,
            )
            scene = scene.with_object(table)
        return scene

    def _random_object(self, rng: np.random.Generator, name: str, shape: Shape | None = None) -> SceneObject:
        pose = np.eye(4)
        pose[:3, :3] = random_rotation(rng)
        margin = float(rng.choice([0.0, 0.0, 0.005, 0.01, 0.02]))
        return SceneObject(name, shape or random_thing(rng, self._parts), pose, margin_m=margin)

    def _holding(self, rng: np.random.Generator, scene: PlanningScene, large: bool = False) -> PlanningScene:
        hand = self._hands[int(rng.integers(len(self._hands)))]
        gripper = self._model.description.grippers[hand]
        shape: Shape = Cylinder(radius := rng.uniform(0.02, 0.038), high := rng.uniform(0.08, 0.16))
        size_m = (2.0 * radius, 2.0 * radius, high)
        if large:
            shape = Box(size_m := (rng.uniform(0.03, 0.08), rng.uniform(0.03, 0.3), rng.uniform(0.2, 0.6)))
        if self._parts:
            shape = shape_of_parts(rng, size_m)
        item = SceneObject("held thing", shape, np.eye(4))
        tilt = poses.rotation_x(rng.uniform(-0.5, 0.5))
        place = poses.transform(tilt, (rng.uniform(0.0, 0.03), 0.0, rng.uniform(-0.03, 0.03)))
        return scene.with_object(item).with_attached(
            "held thing", gripper.tcp_frame, place, gripper.touch_links, HELD_KG
        )

    def _limit(self, rng: np.random.Generator, size: float) -> tuple[Trajectory, PlanningScene, float] | None:
        over = 0.0105 if rng.random() < 0.5 else 10.0 * size
        which = rng.choice(["position", "velocity", "acceleration", "jerk", "spike"])
        if which == "position":
            motion, over = self._past_the_end(rng, size)
            return self._timed(rng, motion), PlanningScene(), over
        if which == "spike":
            trajectory = self._timed(rng, random_motion(self._model, rng))
            v = trajectory.v.copy()
            row, joint = int(rng.integers(1, len(v) - 1)), int(rng.integers(len(self._model.joints)))
            v[row, 6 + joint] = (1.0 + over) * self._model.velocity[joint] * rng.choice([-1.0, 1.0])
            return replace(trajectory, v=v), PlanningScene(), over
        for _ in range(30):
            group = str(rng.choice(self._limbs))
            motion = random_motion(self._model, rng, [group])
            keep = rng.choice(list(motion.joints), size=int(rng.integers(1, 3)), replace=False)
            motion = Motion({int(k): motion.joints[int(k)] for k in keep})
            speed, acceleration, jerk = (ratio.max() for ratio in self._choreographer.ratios(motion))
            durations = {
                "velocity": speed / (1.0 + over),
                "acceleration": np.sqrt(acceleration / (1.0 + over)),
                "jerk": np.cbrt(jerk / (1.0 + over)),
            }
            duration = float(durations[str(which)])
            pure = all(
                ratio / duration**power < 0.98
                for name, ratio, power in (
                    ("velocity", speed, 1),
                    ("acceleration", acceleration, 2),
                    ("jerk", jerk, 3),
                )
                if name != which
            )
            if pure and duration < self._longest_s:
                times = sample_times(rng, duration)
                return self._choreographer.trajectory(motion, duration, times), PlanningScene(), over
        return None

    def _past_the_end(self, rng: np.random.Generator, size: float) -> tuple[Motion, float]:
        model = self._model
        motion = random_motion(model, rng, [str(rng.choice(self._limbs))])
        joint = int(rng.choice(list(motion.joints)))
        room = np.array([model.lower_rad[joint], model.upper_rad[joint]]) - model.q_home[7 + joint]
        side = int(rng.integers(2))
        way = -1.0 if side == 0 else 1.0
        far = float(room[side]) + way * max(size, 0.0)
        profile = Profile(far) if rng.random() < 0.5 else Profile(0.0, back=far)
        return Motion({**motion.joints, joint: profile}, motion.pelvis), size

    def _self(self, rng: np.random.Generator, size: float) -> tuple[Trajectory, PlanningScene, float] | None:
        """An arm motion made as large as it takes to sink in by ``size``."""
        group = str(rng.choice(self._arms))
        model = self._model
        whole = random_motion(model, rng, [group] if rng.random() < 0.6 else self._arms)
        joints = {}
        for index in whole.joints:
            lower, upper = model.lower_rad[index] + 0.02, model.upper_rad[index] - 0.02
            target = rng.uniform(lower, upper) - model.q_home[7 + index]
            there = rng.random() < 0.7
            joints[index] = Profile(target) if there else Profile(0.0, back=target)
        trajectory = self._sink(Motion(joints, whole.pelvis), PlanningScene(), size, rng)
        return None if trajectory is None else (trajectory, PlanningScene(), size)

    def _sink(
        self, motion: Motion, scene: PlanningScene, size: float, rng: np.random.Generator
    ) -> Trajectory | None:
        """Scale a motion until its deepest contact is ``size`` deep."""
        world = SolidWorld(self._model, scene)
        s = np.linspace(0.0, 1.0, 60)
        rows, _ = self._choreographer.unit(Motion(motion.joints), s)
        home = rows[0].copy()

        def sinks(scale: float) -> bool:
            moved = rows.copy()
            moved[:, 7:] = home[7:] + scale * (rows[:, 7:] - home[7:])
            return any(world.nearer_than(q, -size) for q in moved[::3])

        if not sinks(1.0):
            return None
        low, high = 0.0, 1.0
        while high - low > 0.01:
            middle = 0.5 * (low + high)
            low, high = (low, middle) if sinks(middle) else (middle, high)
        scaled = {index: profile.scaled(high) for index, profile in motion.joints.items()}
        return self._timed(rng, Motion(scaled, motion.pelvis))

    def _scene(self, rng: np.random.Generator, size: float) -> tuple[Trajectory, PlanningScene, float] | None:
        if rng.random() < 0.3:
            return self._graze(rng)
        trajectory = self._with_use(rng, random_motion(self._model, rng), rng.uniform(0.5, 0.97))
        if self._alone(trajectory).unsafe:
            return None
        scene = self._surroundings(rng, trajectory) if rng.random() < 0.5 else PlanningScene()
        item = self._random_object(rng, "obstacle")
        placed = self._placer.place(rng, trajectory, scene, item, -size)
        return None if placed is None else (trajectory, scene.with_object(placed), size)

    def _graze(self, rng: np.random.Generator) -> tuple[Trajectory, PlanningScene, float] | None:
        """A fast arm that just touches something, for a few milliseconds."""
        group = str(rng.choice(self._arms))
        trajectory = self._with_use(rng, random_motion(self._model, rng, [group]), 0.97)
        if self._alone(trajectory).unsafe:
            return None
        size = float(np.exp(rng.uniform(np.log(0.0001), np.log(0.001))))
        item = self._random_object(rng, "obstacle")
        placed = self._placer.place(rng, trajectory, PlanningScene(), item, -size, around_s=0.06)
        return None if placed is None else (trajectory, PlanningScene().with_object(placed), size)

    def _thin(self, rng: np.random.Generator, size: float) -> tuple[Trajectory, PlanningScene, float] | None:
        """A rod of 1 mm in the way of a fast motion."""
        trajectory = self._with_use(rng, random_motion(self._model, rng), rng.uniform(0.7, 0.97))
        if self._alone(trajectory).unsafe:
            return None
        rod = Cylinder(_THIN_RADIUS_M, rng.uniform(0.05, 0.6))
        item = self._random_object(rng, "obstacle", rod)
        placed = self._placer.place(rng, trajectory, PlanningScene(), item, -size)
        return None if placed is None else (trajectory, PlanningScene().with_object(placed), size)

    def _brief(self, rng: np.random.Generator, size: float) -> tuple[Trajectory, PlanningScene, float] | None:
        """A fast hand that clips the end or the side of something thin for less than 10 ms."""
        hand = self._hands[int(rng.integers(len(self._hands)))]
        trajectory = self._with_use(rng, random_motion(self._model, rng, [f"{hand}_arm"]), 0.97)
        # deeper than some millimetres nothing is for so short a time
        size = min(size, float(np.exp(rng.uniform(np.log(0.0002), np.log(0.003)))))
        shape: Shape = Cylinder(rng.uniform(_THIN_RADIUS_M, 0.003), rng.uniform(0.02, 0.3))
        if rng.random() < 0.3:
            shape = Ball(rng.uniform(0.001, 0.005))
        item = replace(self._random_object(rng, "obstacle", shape), margin_m=0.0)
        finger = str(rng.choice(self._model.description.grippers[hand].links))
        placed = self._placer.place(
            rng, trajectory, PlanningScene(), item, -size, finger, around_s=0.02, beside=True
        )
        if placed is None:
            return None
        scene = PlanningScene().with_object(placed)
        brief = self._placer.is_brief(trajectory, scene, "obstacle", _BRIEF_S)
        if not brief or self._alone(trajectory).unsafe:
            return None
        return trajectory, scene, size

    def _held(self, rng: np.random.Generator, size: float) -> tuple[Trajectory, PlanningScene, float] | None:
        scene = self._holding(rng, PlanningScene(), large=rng.random() < 0.5)
        held = scene.attached["held thing"]
        hand = "left" if "left" in held.frame else "right"
        motion = random_motion(self._model, rng, [f"{hand}_arm"])
        if rng.random() < 0.4:
            trajectory = self._sink(motion, scene, size, rng)
            return None if trajectory is None else (trajectory, scene, size)
        trajectory = self._timed(rng, motion)
        if self._alone(trajectory).unsafe:
            return None
        item = self._random_object(rng, "obstacle")
        placed = self._placer.place(rng, trajectory, scene, item, -size, link="held thing")
        return None if placed is None else (trajectory, scene.with_object(placed), size)

    def _balance(
        self, rng: np.random.Generator, size: float
    ) -> tuple[Trajectory, PlanningScene, float] | None:
        """The pelvis, with the feet in place, takes the CoM beyond its margin by ``size``."""
        base = random_motion(self._model, rng)
        direction = str(rng.choice(["x", "y"]))
        way = rng.choice([-1.0, 1.0])
        back = rng.random() < 0.5
        times = np.linspace(0.0, 1.0, 25)
        small = min(size, 0.05)

        def motion(shift: float) -> Motion:
            profile = Profile(0.0, back=way * shift) if back else Profile(way * shift)
            return Motion(base.joints, {direction: profile})

        def missing(shift: float) -> float:
            trajectory = self._choreographer.trajectory(motion(shift), 10.0, times * 10.0, times)
            return self._model.description.com_margin_m - self._referee.com_margin_m(trajectory)

        low, high = 0.0, 0.02
        while missing(high) < small:
            low, high = high, high + 0.02
            if high > 0.25:
                return None
        while high - low > 0.001:
            middle = 0.5 * (low + high)
            low, high = (middle, high) if missing(middle) < small else (low, middle)
        return self._timed(rng, motion(high)), PlanningScene(), small

    def _jump(self, rng: np.random.Generator, size: float) -> tuple[Trajectory, PlanningScene, float] | None:
        trajectory = self._timed(rng, random_motion(self._model, rng))
        q, v = trajectory.q.copy(), trajectory.v.copy()
        row = int(rng.integers(1, len(q)))
        rows = slice(row, None) if rng.random() < 0.5 else slice(row, row + int(rng.integers(1, 4)))
        which = rng.choice(["joint", "base", "turn", "speed"])
        way = rng.choice([-1.0, 1.0])
        if which == "joint":
            q[rows, 7 + int(rng.integers(len(self._model.joints)))] += way * size
        elif which == "base":
            q[rows, int(rng.integers(3))] += way * size
        elif which == "turn":
            turn = np.append(np.sin(0.5 * size) * np.eye(3)[int(rng.integers(3))], np.cos(0.5 * size))
            q[rows, 3:7] = [quaternion_product(turn, row_q) for row_q in q[rows, 3:7]]
        else:
            joint = int(rng.integers(len(self._model.joints)))
            v[rows, 6 + joint] += way * (0.3 + 10.0 * size)
        return replace(trajectory, q=q, v=v), PlanningScene(), size
