"""Suites of walking at a velocity, and of stopping in the middle of it."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from executive.session.assembly import Assembly
from executive.session.task_result import TaskResult
from kinematics.geometry import poses
from robots.control.events import MotionStarted
from robots.scenes.scene_description import PerceptionModel, RobotStart, SceneDescription
from tools.evaluate.skills.suite import SkillSuite, Trial, Verdict
from trees.tasks import MoveTask

COMMANDS = ((0.3, 0.0), (-0.3, 0.0), (0.0, 0.5), (0.0, -0.5), (0.5, 0.0))
"""Metres and radians a second that the demands name."""
LOW_COMMANDS = ((0.3, 0.0), (-0.3, 0.0), (0.0, 0.4), (0.0, -0.4))
"""The same of a humanoid of a child's size."""
PACES = ((-0.5, 0.5), (-0.5, 0.5))
"""Between which metres and radians a second a walk goes that is stopped."""
LOW_PACES = ((-0.3, 0.4), (-0.4, 0.4))
"""The same of a humanoid of a child's size."""
DURATION_S = 20.0
MEASURED_FROM_S = 3.0
OFF_SHARE = 0.05

STOP_WITHIN_S = 2.2
STOP_STEPS = 2
STILL_M_S = 0.02
STOP_AT_S = (0.2, 8.0)
"""From the first weight shift to the full pace."""
_KINDS = ("cancel", "stop 1", "stop 2", "emergency")
_LIFTED_M = 0.004


def floor(name: str, rng: np.random.Generator) -> SceneDescription:
    """Nothing but a floor, and the robot somewhere on it."""
    x, y = (float(value) for value in rng.uniform(-1.0, 1.0, 2))
    return SceneDescription(name, RobotStart(x, y, float(rng.uniform(-math.pi, math.pi))), PerceptionModel())


class PaceJudge:
    """Measures the mean velocity of the base along its own heading."""

    def __init__(self, assembly: Assembly, trial: Trial, _rng: np.random.Generator) -> None:
        self._truth, self._task = assembly.world.truth, trial.tasks[-1]
        self._began_s = math.inf
        self._last: tuple[float, float, float] | None = None
        self._gone_m = self._turned_rad = 0.0

    def on_event(self, event: object) -> None:
        """Note when it sets out."""
        if isinstance(event, MotionStarted):
            self._began_s = min(self._began_s, event.t_s)

    def on_period(self) -> None:
        """Add up what it goes between the third second and the last."""
        since_s = self._truth.time_s - self._began_s
        if not MEASURED_FROM_S <= since_s <= DURATION_S:
            return
        base = self._truth.world_T_base()
        x, y, yaw = float(base[0, 3]), float(base[1, 3]), poses.yaw_of(base[:3, :3])
        if self._last is not None:
            dx, dy = x - self._last[0], y - self._last[1]
            self._gone_m += math.cos(yaw) * dx + math.sin(yaw) * dy
            self._turned_rad += (yaw - self._last[2] + math.pi) % (2.0 * math.pi) - math.pi
        self._last = x, y, yaw

    def verdict(self, _results: Sequence[TaskResult]) -> Verdict:
        """Within five per cent of what was asked for; what was not asked for, within that of the limits."""
        measured_s = DURATION_S - MEASURED_FROM_S
        linear, angular = self._gone_m / measured_s, self._turned_rad / measured_s
        wanted_m_s = getattr(self._task, "linear_m_s", 0.0)
        wanted_rad_s = getattr(self._task, "angular_rad_s", 0.0)
        off = (
            abs(linear / wanted_m_s - 1.0) if wanted_m_s else abs(linear) / 0.5,
            abs(angular / wanted_rad_s - 1.0) if wanted_rad_s else abs(angular) / 1.0,
        )
        done = max(off) <= OFF_SHARE
        numbers = {
            "wanted_m_s": wanted_m_s,
            "wanted_rad_s": wanted_rad_s,
            "mean_m_s": linear,
            "mean_rad_s": angular,
        }
        return Verdict(done, numbers, "" if done else f"went at {linear:.3f} m/s and {angular:.3f} rad/s")


class StopJudge:
    """Stops the walk at some instant, and measures what the robot still does."""

    def __init__(self, assembly: Assembly, trial: Trial, rng: np.random.Generator) -> None:
        self._assembly, self._truth = assembly, assembly.world.truth
        self._at_s = float(rng.uniform(*STOP_AT_S))
        self._kind = _KINDS[int(rng.integers(len(_KINDS)))]
        self._began_s = math.inf
        self._stopped_s: float | None = None
        self._moving_s = 0.0
        self._last = np.zeros(3)
        self._up = [False, False]
        self._steps = 0
        task = trial.tasks[-1]
        self._asked = (getattr(task, "linear_m_s", 0.0), getattr(task, "angular_rad_s", 0.0))

    def on_event(self, event: object) -> None:
        """Note when it sets out."""
        if isinstance(event, MotionStarted):
            self._began_s = min(self._began_s, event.t_s)

    def on_period(self) -> None:
        """Stop at the instant; afterwards look until it stands still."""
        now_s = self._truth.time_s
        base = self._truth.world_T_base()[:3, 3]
        if self._stopped_s is None and now_s - self._began_s >= self._at_s:
            self._stopped_s = now_s
            self._stop()
        if self._stopped_s is not None:
            if float(np.linalg.norm(base - self._last)) / 0.002 > STILL_M_S:
                self._moving_s = now_s - self._stopped_s
            physics = self._assembly.world.physics
            for k, body in enumerate(physics.sole_body):
                up = float(physics.data.xpos[body][2]) > _LIFTED_M
                self._steps += int(self._up[k] and not up)
                self._up[k] = up
        self._last = base.copy()

    def _stop(self) -> None:
        session, loop = self._assembly.session, self._assembly.loop
        if self._kind == "cancel":
            session.cancel("stop here")
        elif self._kind == "emergency":
            session.emergency_stop("the button")
        else:
            loop.stop(int(self._kind[-1]), "stop here")

    def verdict(self, _results: Sequence[TaskResult]) -> Verdict:
        """Still in time, and within two landings."""
        done = self._stopped_s is not None and self._moving_s <= STOP_WITHIN_S and self._steps <= STOP_STEPS
        numbers = {
            "stop": self._kind,
            "at_s": self._at_s,
            "linear_m_s": self._asked[0],
            "angular_rad_s": self._asked[1],
            "moved_on_s": self._moving_s,
            "steps": self._steps,
        }
        why = "" if done else f"{self._kind}: moved on for {self._moving_s:.2f} s, {self._steps} steps"
        return Verdict(done, numbers, why)


def walk_trial(rng: np.random.Generator, commands: Sequence[tuple[float, float]] = COMMANDS) -> Trial:
    """One of the velocities that the demands name."""
    linear, angular = commands[int(rng.integers(len(commands)))]
    task = MoveTask(f"move at {linear} m/s, {angular} rad/s", linear, angular, DURATION_S)
    return Trial(floor("walk", rng), (task,))


def stop_trial(rng: np.random.Generator, paces: Sequence[tuple[float, float]] = PACES) -> Trial:
    """Any velocity within the limits."""
    linear, angular = (round(float(rng.uniform(*pace)), 2) for pace in paces)
    return Trial(floor("walk_stop", rng), (MoveTask("move", linear, angular, 30.0),))


WALK = SkillSuite(walk_trial, PaceJudge, stands=False, on_low=lambda rng: walk_trial(rng, LOW_COMMANDS))
WALK_STOP = SkillSuite(
    stop_trial, StopJudge, stands=False, ends="cancelled", on_low=lambda rng: stop_trial(rng, LOW_PACES)
)
