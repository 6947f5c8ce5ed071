"""Build a simulated world: one robot in one scene."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from robots.interface.hardware import RobotData
from robots.scenes.scene_description import SceneDescription
from robots.simulated.body.physics import Physics
from robots.simulated.body.range_sensor import SimulatedRangeSensor
from robots.simulated.body.simulated_robot import SimulatedRobot
from robots.simulated.faults.body_faults import BodyFaults
from robots.simulated.faults.world_faults import FaultInjector
from robots.simulated.people.taking_people import TakingPeople
from robots.simulated.people.walking_people import WalkingPeople
from robots.simulated.truth.truth import SimulatorTruth


@dataclass(frozen=True, slots=True)
class SimulatedWorld:
    """A world that goes on only when its robot's ``advance`` is called.

    Attributes:
        robot: The body, as the control loop knows it.
        truth: What really is the case; for the perception stub, evaluation and tests only.
        faults: Things that go wrong on purpose.
        body_faults: The same, of the robot's own body.
        ranging: The range sensor.
        people: Those of its people who take what is offered to them.
        walkers: Those who walk about.
        before_period: What everything but the robot does before each period; called by its robot's
            ``advance``, or by who plays the robot's motors.
        physics: MuJoCo's model and data; for ``robots.simulated`` (rendering, monitor) and tests.
    """

    robot: SimulatedRobot
    truth: SimulatorTruth
    faults: FaultInjector
    body_faults: BodyFaults
    physics: Physics
    ranging: SimulatedRangeSensor
    people: TakingPeople
    walkers: WalkingPeople
    before_period: Callable[[], None]


def build_world(
    robot: RobotData, scene: SceneDescription, rng: np.random.Generator, *, drawn: bool = True
) -> SimulatedWorld:
    """Build a world with the robot standing at the scene's ``robot_start`` in its home posture.

    Args:
        description: The robot.
        scene: Everything else; ``robots.scenes.scene_rules.validate`` has judged it.
        rng: Source of the sensors' noise; used by nothing else.
        drawn: Whether pictures may be taken in it; a camera of the scene takes them anyhow.

    Raises:
        SceneError: The robot would start in contact with something, or the simulator refuses the scene.
        DescriptionError: The URDF lacks what the description names.
    """
    seen = scene.perception.kind != "stub" or bool(scene.cameras)
    physics = Physics(robot, scene, drawn=drawn or seen)
    truth = SimulatorTruth(physics)
    faults = FaultInjector(physics, truth)
    ranging = SimulatedRangeSensor(physics, rng.spawn(1)[0])

    people = TakingPeople(physics, truth)
    walkers = WalkingPeople(physics)

    def before_period() -> None:
        faults.tick()
        people.tick()
        walkers.tick()
        physics.furniture.apply()

    body = SimulatedRobot(physics, rng, before_period)
    return SimulatedWorld(
        body,
        truth,
        faults,
        BodyFaults(physics, body, faults),
        physics,
        ranging,
        people,
        walkers,
        before_period,
    )
