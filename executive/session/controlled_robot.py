"""A robot under control, in this process or in one of its own, and the session that is put on it."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass
from typing import Protocol

from executive.session.events import Event, EventHub, EventSink
from executive.session.lockstep import Periods
from executive.session.pause import Pausable
from executive.session.session import PlanningTimes, Session, TreeBuilder
from executive.session.supervisor import Guarded, Supervisor
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel
from robots.clock import Clock
from robots.perception.detector import Detector, RangeSensor
from robots.perception.fusion.cameras import PlacedCamera
from robots.scenes.scene_description import Region
from robots.seeded import Seeded
from trees.build import TaskTree
from trees.events import Offered
from trees.policy import TreePolicy
from trees.self_knowledge import Calendar, Identity
from trees.toolbox import Gripper, Jogging, MotionControl, Planning, Toolbox, VelocityFeed, Walking, Yielding
from trees.world_model import WorldModel


class TimedPlanning(Planning, PlanningTimes, Protocol):
    """A planning service that knows how long it took."""


@dataclass(frozen=True, slots=True)
class ControlledRobot:
    """Everything of a robot that an executive reaches.

    With the control loop in the same process these are its parts; else each is a client of the control
    process.

    Attributes:
        model: The robot's model.
        clock: Simulated time, or control time.
        periods: Lets a control period pass; knows what is sensed.
        guard: The emergency stop's latch, and what is wrong with the robot.
        pausing: Holds the robot in the middle of a motion.
        motion: The way to the motors.
        grippers: The gripper of each hand that has one.
        walking: The way to the feet.
        yielding: The way to a hand that yields to what it holds.
        jogging: The way to what a person jogs.
        detector: What the camera shows.
        ranging: What the range sensor scans.
        planning: The planning service.
        see_offer: Told whom something is held out to; in a simulated world, the people there see it.
        cameras: Those that stand in the room.
    """

    model: RobotModel
    clock: Clock
    periods: Periods
    guard: Guarded
    pausing: Pausable
    motion: MotionControl
    grippers: Mapping[Hand, Gripper]
    walking: Walking | None
    yielding: Yielding | None
    jogging: Jogging | None
    detector: Detector
    ranging: RangeSensor | None
    planning: TimedPlanning
    see_offer: Callable[[str], None]
    cameras: tuple[PlacedCamera, ...] = ()


def session_on(
    robot: ControlledRobot,
    sink: EventSink,
    chance: Seeded,
    places: Mapping[str, Region],
    *,
    velocities: VelocityFeed | None = None,
    world: WorldModel | None = None,
    policy: TreePolicy | None = None,
    build: TreeBuilder | None = None,
    tick_sensors: Callable[[], None] | None = None,
    on_period: Callable[[], None] | None = None,
    on_tick: Callable[[TaskTree], None] | None = None,
    identity: Identity | None = None,
    calendar: Calendar | None = None,
    people: Collection[str] = (),
) -> tuple[Session, Supervisor]:
    """Put a session on a robot, with a toolbox for its trees and somebody who supervises it.

    Args:
        robot: What is reached of the robot.
        sink: Takes every event.
        chance: The run's randomness; the trees draw from theirs.
        places: The map of the rooms.
        velocities: What is sent to walk at, where somebody can send it.
        world: What is believed of the world already; nothing when left out.
        policy: Numbers that behaviors go by.
        build: Makes a task's tree; `build_tree` when left out.
        tick_sensors: Called each control period: simulated sensors that run beside the loop.
        on_period: Called after each control period.
        on_tick: Called after each tick of a tree.
        identity: What it says of itself; nothing when left out.
        calendar: What day and time it is; the usual beginning of a simulated day when left out.
        people: What the people of the place are called, so that their names are understood.
    """
    hub = sink if isinstance(sink, EventHub) else EventHub(sink)

    def watched(event: Event) -> None:
        if isinstance(event, Offered):
            robot.see_offer(event.to)

    hub.listen(watched)
    toolbox = Toolbox(
        clock=robot.clock,
        model=robot.model,
        motion=robot.motion,
        sensing=robot.periods.sensing,
        grippers=robot.grippers,
        detector=robot.detector,
        planning=robot.planning,
        world=world or WorldModel(),
        events=hub,
        rng=chance.trees,
        policy=policy or TreePolicy(),
        walking=robot.walking,
        ranging=robot.ranging,
        yielding=robot.yielding,
        jogging=robot.jogging,
        places=places,
        velocities=velocities,
        identity=identity or Identity(),
        calendar=calendar or Calendar(),
        cameras=robot.cameras,
        people=frozenset(people),
    )
    supervisor = Supervisor(robot.guard, robot.clock, hub)
    session = Session(
        toolbox,
        robot.periods,
        robot.planning,
        hub,
        tick_sensors=tick_sensors,
        on_period=on_period,
        on_tick=on_tick,
        build=build,
        supervisor=supervisor,
        pausing=robot.pausing,
    )
    return session, supervisor
