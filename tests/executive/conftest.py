"""A session with the fake robot: whole trees in milliseconds, without physics."""

import numpy as np
import pytest
from py_trees.blackboard import Blackboard

from executive.embedding.requests import Requests
from executive.session.planning_jobs import PlanningJobs
from executive.session.session import Session
from executive.session.supervisor import Supervisor
from kinematics.model.robot_model import RobotModel
from kinematics.motion.verdict import CheckedTrajectory
from robots.control.loop.emergency_stop import EmergencyStop
from robots.fake.fake_world import FakeWorld, cup, table
from robots.models.description import load_description, load_robot
from trees.policy import TreePolicy
from trees.skills.pick.settings import PickSettings
from trees.toolbox import Toolbox
from trees.world_model import WorldModel

HARDWARE = load_robot("talos").hardware

QUICK = TreePolicy(
    skills=(PickSettings(hold_s=0.2, grasp_settle_s=0.04),),
    look_frames=2,
    look_timeout_s=0.4,
    motion_slack_s=0.2,
)


def believed(request):
    """What a checker that finds nothing would answer; only tests may make one up."""
    checked = object.__new__(CheckedTrajectory)
    found = {
        "trajectory": request.trajectory, "min_distance_m": 0.02,
        "min_com_margin_m": 0.03, "seal": None,
    }  # fmt: skip
    for name, value in found.items():
        object.__setattr__(checked, name, value)
    return checked


class Loop:
    """Steps the fake robot once every ten control periods."""

    def __init__(self, fake):
        self.fake, self.sensing, self.count = fake, fake.sensing, 0

    def step(self):
        self.count += 1
        if self.count % 10 == 0:
            self.fake.step()


class Guard:
    """A latch that only notes that it is engaged."""

    defects = reservations = ()
    still, emergency = True, None

    def emergency_stop(self, reason, category=1):
        self.emergency = EmergencyStop(0.0, category, reason)

    def reset(self, request):
        self.emergency = None


class FakeStage:
    """A session with a fake robot at a table, and what it told."""

    def __init__(self, model, *things, places=(), guarded=False):
        self.fake, self.events = FakeWorld(model, HARDWARE, believed, [table(), *things]), []
        toolbox = Toolbox(
            clock=self.fake.clock, model=model, motion=self.fake.motion, sensing=self.fake.sensing,
            grippers=self.fake.grippers, detector=self.fake.detector, planning=self.fake.planning,
            world=WorldModel(), events=lambda event: self.session.tell(event),
            rng=np.random.default_rng(1), policy=QUICK, places=dict(places),
        )  # fmt: skip
        planning = PlanningJobs(None, None, self.fake.clock, self.events.append)
        guard = Supervisor(Guard(), self.fake.clock, self.events.append) if guarded else None
        self.session = Session(toolbox, Loop(self.fake), planning, self.events.append, supervisor=guard)
        self.requests = Requests(self.session)

    def arms_moved(self):
        model, q = self.fake.model, self.fake.motion.reference()[7:]
        arms = [i for i, name in enumerate(model.joints) if name.startswith("arm_")]
        return len(arms) == 14 and bool(np.abs(q - model.q_home[7:])[arms].max() > 1e-6)

    def of(self, kind):
        return [event for event in self.events if isinstance(event, kind)]


@pytest.fixture(scope="session")
def fake_model():
    return RobotModel(load_description("talos"))


@pytest.fixture
def fake_stage(fake_model):
    """Make a stage; without things there are a red and a blue cup on the table."""
    yield lambda *things, **more: FakeStage(
        fake_model, *(things or (cup("a", "red", (0.45, 0.2)), cup("b", "blue", (0.45, -0.2)))), **more
    )
    Blackboard.clear()
