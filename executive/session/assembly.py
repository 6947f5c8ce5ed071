"""The one place where concrete parts are put together: a simulated robot in a scene, with a session."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from executive.session.controlled_robot import ControlledRobot, session_on
from executive.session.events import EventHub, EventSink
from executive.session.planning_jobs import PlanningJobs
from executive.session.session import Session, TreeBuilder
from executive.session.supervisor import Supervisor
from executive.understanding.canonical_detector import CanonicalDetector, in_canonical_words
from executive.understanding.canonical_words import canonical_kind
from kinematics.checking.trajectory_checker import TrajectoryChecker
from kinematics.model.robot_model import RobotModel
from kinematics.motion.verdict import CheckedTrajectory, Unsafe
from kinematics.motion_planner import MotionPlanner
from kinematics.requests.check import CheckRequest
from robots.clock import ManualClock
from robots.control.loop.control_loop import ControlLoop
from robots.control.period import PERIOD_S
from robots.interface.hardware import RobotData
from robots.interface.robot import Robot
from robots.models.description import load_robot_for_tasks
from robots.perception.labels.labelling import BY_SHAPE, Labelling
from robots.perception.place_map import place_map
from robots.scenes.planned_fault import PlannedFault
from robots.scenes.scene_description import SceneDescription, names_of_people
from robots.seeded import Seeded
from robots.simulated.eyes import SimulatedPerception, placed_cameras, simulated_perception
from robots.simulated.fault_plan import plan_fault
from robots.simulated.world import SimulatedWorld, build_world
from trees.build import TaskTree
from trees.policy import TreePolicy
from trees.self_knowledge import Calendar, Identity


@dataclass(frozen=True, slots=True)
class Assembly:
    """A robot in a simulated world, ready for its first task.

    Attributes:
        world: The simulator: its truth is for tests, evaluations and pictures alone.
        session: Runs tasks.
        loop: The control loop, for its statistics.
        perception: The simulated perception, for faults.
        planning: The planning service, for its counts and times.
        model: The robot's model.
        clock: Simulated time.
        supervisor: Emergency stop, reset and the state machine.
    """

    world: SimulatedWorld
    session: Session
    loop: ControlLoop
    perception: SimulatedPerception
    planning: PlanningJobs
    model: RobotModel
    clock: ManualClock
    supervisor: Supervisor


FRAMES_OF_A_CAMERA = 5
"""Of one look: what calibration leaves is the same in all pictures, and a few average the noise down."""


def policy_for(scene: SceneDescription) -> TreePolicy:
    """The usual numbers, for the way in which things are seen in a scene."""
    usual = TreePolicy()
    if scene.perception.kind == "rgbd":
        return replace(usual, look_frames=min(usual.look_frames, FRAMES_OF_A_CAMERA))
    return usual


def assemble(
    robot: str,
    scene: SceneDescription,
    seed: int,
    *,
    sink: EventSink = lambda _event: None,
    on_period: Callable[[], None] | None = None,
    on_tick: Callable[[TaskTree], None] | None = None,
    policy: TreePolicy | None = None,
    build: TreeBuilder | None = None,
    posture: Mapping[str, float] | None = None,
    on_judged: Callable[[CheckRequest, CheckedTrajectory | Unsafe], None] = lambda _request, _answer: None,
    identity: Identity | None = None,
    calendar: Calendar | None = None,
    labelling: Labelling = BY_SHAPE,
    picture_slot: Path | None = None,
    drawn: bool = True,
    body: Callable[[SimulatedWorld, ManualClock], Robot] | None = None,
) -> Assembly:
    """Put a robot into a scene.

    Each consumer of randomness draws from a child of ``seed`` of its own, in a fixed order, so that one
    that draws more or less does not change what the others see.

    Args:
        robot: Name of the robot.
        scene: What is around it.
        seed: Of everything random.
        sink: Takes every event.
        on_period: Called after each control period.
        on_tick: Called after each tick of a tree.
        policy: Numbers that behaviors go by.
        build: Makes a task's tree; `build_tree` when left out.
        posture: Positions of joints that are not where the home posture has them; it is home then.
        on_judged: Called with every motion that the checker judged, and its answer.
        identity: What the robot says of itself; nothing when left out.
        calendar: What day and time it is; when left out the usual beginning of a simulated day.
        labelling: Who is asked, of the camera's pictures, what things are called.
        picture_slot: Where the newest picture of the robot's own camera is shown to who wants it; None for
            nowhere.
        drawn: Whether pictures may be taken of the robot; a world without is a third as large.
        body: Gives what the control loop commands in the world's robot's place, and what lets its time pass:
            the same robot behind a wire.

    Raises:
        UnknownRobotError: There is no robot of that name.
        DescriptionError: The robot's data are incomplete, or it lacks a part that tasks need.
        SceneError: The scene cannot be a world.
    """
    sink = EventHub(sink)
    chance = Seeded.by(seed)
    data = load_robot_for_tasks(robot)
    description = data.description
    if posture:
        description = replace(description, home={**description.home, **posture})
    model = RobotModel(description)
    clock = ManualClock()
    world = build_world(RobotData(description, data.hardware), scene, chance.world, drawn=drawn)

    commanded = world.robot if body is None else body(world, clock)
    loop = ControlLoop(commanded, model, clock, sink, PERIOD_S)
    perception = simulated_perception(
        world,
        RobotData(description, data.hardware),
        scene,
        clock,
        chance.perception,
        loop.sensing,
        model,
        labelling=labelling,
        slot=picture_slot,
    )

    planning = PlanningJobs(MotionPlanner(model), TrajectoryChecker(model), clock, sink, on_judged=on_judged)
    robot_here = ControlledRobot(
        model=model,
        clock=clock,
        periods=loop,
        guard=loop,
        pausing=loop,
        motion=loop.motion,
        grippers=loop.grippers,
        walking=loop.walking,
        yielding=loop.yielding,
        jogging=loop.jogging,
        detector=CanonicalDetector(perception, canonical_kind),
        ranging=world.ranging,
        planning=planning,
        see_offer=world.people.see_offer,
        cameras=tuple(map(in_canonical_words, placed_cameras(perception, scene))),
    )
    session, supervisor = session_on(
        robot_here,
        sink,
        chance,
        place_map(scene, chance.places),
        policy=policy or policy_for(scene),
        build=build,
        tick_sensors=perception.tick,
        on_period=on_period,
        on_tick=on_tick,
        identity=identity,
        calendar=calendar,
        people=names_of_people(scene),
    )
    return Assembly(world, session, loop, perception, planning, model, clock, supervisor)


def plan_faults(world: SimulatedWorld, faults: Iterable[PlannedFault]) -> None:
    """Let things go wrong on purpose, each at its simulated time.

    Raises:
        ValueError: There is no such joint or object.
    """
    for fault in faults:
        plan_fault(world, fault)
