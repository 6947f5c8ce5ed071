"""What leaves may call, and nothing else."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Protocol, TypeVar

import numpy as np
from numpy.typing import NDArray

from kinematics.following.jog_reference import Jog
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import Stance
from kinematics.motion.verdict import CheckedTrajectory, Unsafe
from kinematics.requests.check import CheckRequest
from kinematics.requests.request import Request
from kinematics.scene.planning_scene import PlanningScene
from kinematics.walking.pattern.steering import Steering
from robots.clock import Clock
from robots.control.guarded.guarded_motion import GuardedMotion
from robots.control.hands.jogged_body import JogReport
from robots.control.hands.yield_order import YieldOrder
from robots.control.hands.yield_settings import YieldReport
from robots.control.motion_handle import MotionHandle
from robots.interface.gripper_reading import GripperReading
from robots.interface.sensed_state import SensedState
from robots.perception.detector import Detector, RangeSensor
from robots.perception.fusion.cameras import PlacedCamera
from robots.scenes.scene_description import Region
from trees.events import TreeSink
from trees.policy import TreePolicy
from trees.self_knowledge import Calendar, Identity
from trees.world_model import WorldModel

Planned = TypeVar("Planned")
Answer = TypeVar("Answer", covariant=True)


@dataclass(slots=True)
class Pauses:
    """How long trees have been paused so far: who runs tasks adds to it, and deadlines leave that time out.

    Attributes:
        total_s: Seconds on the injected clock, since the beginning, in which trees were not ticked.
    """

    total_s: float = 0.0


@dataclass(frozen=True, slots=True)
class HeardVelocity:
    """A velocity of the base.

    Attributes:
        linear_m_s: Forward speed.
        angular_rad_s: Turning speed, to the left.
        heard_s: Control time at which it came.
    """

    linear_m_s: float
    angular_rad_s: float
    heard_s: float


class VelocityFeed:
    """Holds the newest velocity; what is older is forgotten.

    Attributes:
        newest: It, or None before the first one.
    """

    def __init__(self) -> None:
        self.newest: HeardVelocity | None = None

    def hear(self, linear_m_s: float, angular_rad_s: float, now_s: float) -> None:
        """Take a velocity in the place of the one before."""
        self.newest = HeardVelocity(linear_m_s, angular_rad_s, now_s)


class MotionControl(Protocol):
    """Starts and cancels motions of the body: the motion streamer itself, or a client of it."""

    def start(self, motion: CheckedTrajectory | GuardedMotion) -> MotionHandle:
        """Begin to stream a motion; refused at once when it does not start at the reference."""
        ...

    def cancel(self, handle: MotionHandle, reason: str) -> None:
        """Brake a running motion within limits, then hold (stop category 1)."""
        ...

    def reference(self) -> NDArray[np.float64]:
        """Configuration that is commanded now, base included, shape (nq,)."""
        ...

    def stance(self) -> Stance:
        """Where the feet stand."""
        ...


class Walking(Protocol):
    """Starts, steers and ends walks; while a walk is under way nothing else moves the body.

    The head looks where a ``Gazing`` steering says.
    """

    @property
    def active(self) -> bool:
        """Whether a walk is under way, its last steps included."""
        ...

    def walk(self, steering: Steering, name: str) -> MotionHandle:
        """Set out; refused at once when the robot does not stand at rest."""
        ...

    def steer(self, handle: MotionHandle, steering: Steering) -> None:
        """Go somewhere else with a walk that is under way."""
        ...

    def finish(self, handle: MotionHandle) -> None:
        """Come to an end within the last steps; the handle is done when the robot stands."""
        ...

    def cancel(self, handle: MotionHandle, reason: str) -> None:
        """The same, but the handle is cancelled at once."""
        ...


class YieldingMotion(Protocol):
    """A motion that is under way, in which a hand leads something along and gives way across it."""

    @property
    def handle(self) -> MotionHandle:
        """The motion's; the streamer cancels it."""
        ...

    @property
    def report(self) -> YieldReport:
        """What was felt so far."""
        ...

    def finish(self) -> None:
        """Come to rest where the hand is."""
        ...


class Yielding(Protocol):
    """Starts motions in which a hand gives way to what it holds or meets."""

    def start(self, order: YieldOrder) -> YieldingMotion:
        """Begin where the robot is commanded to be now; the handle is refused when it may not."""
        ...


class JoggingMotion(Protocol):
    """A motion that is under way, in which trunk, arms and head go as a person jogs them."""

    @property
    def handle(self) -> MotionHandle:
        """The motion's; the streamer cancels it."""
        ...

    @property
    def report(self) -> JogReport:
        """How it goes."""
        ...

    def steer(self, jog: Jog) -> None:
        """Go on as asked for, for as long as a word is good for; silence brakes."""
        ...

    def brake(self) -> None:
        """Come to rest now, and go on listening."""
        ...

    def finish(self) -> None:
        """Come to rest, and end."""
        ...


class Jogging(Protocol):
    """Starts motions that a person makes."""

    def start(self, scene: PlanningScene) -> JoggingMotion:
        """Begin where the robot is commanded to be now, in a scene; the handle is refused when it may not."""
        ...


class Sensing(Protocol):
    """The readings of the robot's own sensors, and the configuration that is estimated from them."""

    def state(self) -> SensedState:
        """The newest readings and the configuration estimated from them."""
        ...

    def state_at(self, stamp_s: float) -> SensedState:
        """The remembered state nearest to a time, for readings that arrive late."""
        ...


class Gripper(Protocol):
    """The gripper of one hand: it opens, closes and tells what it feels."""

    def open(self, opening_m: float | None = None) -> MotionHandle:
        """Open fully, or until the pads are so far apart."""
        ...

    def close(self) -> MotionHandle:
        """Close until something resists, then keep pressing with the described effort."""
        ...

    def reading(self) -> GripperReading:
        """What its sensors say now."""
        ...


class Job(Protocol[Answer]):
    """A request to a planner or to the checker, under way or answered."""

    @property
    def done(self) -> bool:
        """Whether ``result`` may be called; in lockstep not before its charged time has passed."""
        ...

    def result(self) -> Answer:
        """The answer.

        Raises:
            Exception: Whatever the planner or the checker raised.
        """
        ...

    def cancel(self) -> None:
        """Forget about it."""
        ...


class Planning(Protocol):
    """Answers requests to planners and the checker: at once in lockstep, in worker processes in live."""

    def submit(self, request: Request[Planned]) -> Job[Planned]:
        """Begin to answer a request."""
        ...

    def check(self, question: CheckRequest) -> Job[CheckedTrajectory | Unsafe]:
        """Begin to judge a trajectory: a door of its own, for that is no planning."""
        ...


@dataclass(frozen=True, slots=True)
class Toolbox:
    """Everything that a leaf may use: what moves the robot, what it senses, plans and believes."""

    clock: Clock
    model: RobotModel
    motion: MotionControl
    sensing: Sensing
    grippers: Mapping[Hand, Gripper]
    detector: Detector
    planning: Planning
    world: WorldModel
    events: TreeSink
    rng: np.random.Generator
    policy: TreePolicy = field(default_factory=TreePolicy)
    walking: Walking | None = None
    ranging: RangeSensor | None = None
    pauses: Pauses = field(default_factory=Pauses)
    yielding: Yielding | None = None
    jogging: Jogging | None = None
    places: Mapping[str, Region] = field(default_factory=dict)
    velocities: VelocityFeed | None = None
    identity: Identity = field(default_factory=Identity)
    calendar: Calendar = field(default_factory=Calendar)
    cameras: tuple[PlacedCamera, ...] = ()
    people: frozenset[str] = frozenset()

    @property
    def can_walk(self) -> bool:
        """Whether the robot walks here."""
        return self.walking is not None and self.model.description.walking is not None
