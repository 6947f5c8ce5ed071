"""A fake robot on a stage: any leaf or tree is ticked in milliseconds, without physics."""

import pickle
from dataclasses import replace

import numpy as np
import pytest
from py_trees.blackboard import Blackboard
from py_trees.common import Status

from kinematics.dynamics.standing_dynamics import StandingDynamics
from kinematics.geometry import poses
from kinematics.geometry.shapes import Cylinder
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import stance_at
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.verdict import CheckedTrajectory
from kinematics.planning.gesture_planner import GesturePlanner
from kinematics.requests.grasp import Grasp
from kinematics.requests.pick import PickRequest
from kinematics.scene.planning_scene import SceneObject
from robots.fake.fake_gesture import FakeGesture
from robots.fake.fake_world import FakeWorld, cup, table
from robots.models.description import load_description, load_robot
from trees.build import build_tree
from trees.nodes.leaf import Leaf
from trees.policy import TreePolicy
from trees.port_values import CheckedStep, Step, Target
from trees.skills.gestures.settings import GestureSettings
from trees.skills.hand_over.settings import HandOverSettings
from trees.skills.pick.settings import PickSettings
from trees.skills.place.settings import PlaceSettings
from trees.tasks import ObjectDescription, PickTask
from trees.toolbox import Toolbox
from trees.world_model import WorldModel

HARDWARE = load_robot("talos").hardware

QUICK = TreePolicy(
    look_frames=2,
    look_timeout_s=0.4,
    motion_slack_s=0.2,
    task_timeout_s=60.0,
    skills=(
        PickSettings(hold_s=0.2, grasp_settle_s=0.04),
        PlaceSettings(rest_s=0.08),
        HandOverSettings(offer_rest_s=0.08, take_within_s=0.6, after_giving_s=0.04),
        GestureSettings(pointing_hold_s=0.04),
    ),
)
PERIOD_S = 0.02
# Fingers of the fake robot move so many times faster than the true ones.
HURRY = 4.0
RED_CUP = PickTask("pick up the red cup", ObjectDescription("cup", "red"))


def believed(request):
    """What a checker that finds nothing would answer; only tests may make one up."""
    checked = object.__new__(CheckedTrajectory)
    found = {
        "trajectory": request.trajectory,
        "min_distance_m": 0.02,
        "min_com_margin_m": 0.03,
        "seal": None,
    }
    for name, value in found.items():
        object.__setattr__(checked, name, value)
    return checked


class RememberedGestures(GesturePlanner):
    """The planner of gestures, which answers what it was asked before at once: its answers are exact."""

    def __init__(self, model):
        super().__init__(model, FakeGesture)
        self._answers = {}

    def plan(self, request):
        asked = pickle.dumps(request)
        if asked not in self._answers:
            self._answers[asked] = super().plan(request)
        return self._answers[asked]


class Stage:
    """The fake world with a toolbox around it, and ways to run nodes in it.

    Its motions are as short as one can be that is met under way; a test that needs more makes them longer.
    """

    def __init__(
        self,
        model,
        objects=None,
        policy=QUICK,
        period_s=PERIOD_S,
        dynamics=None,
        looks_for_twins=True,
        walks=False,
        motion_s=2 * PERIOD_S,
    ):
        things = [table(), cup()] if objects is None else objects
        self.fake = FakeWorld(model, HARDWARE, believed, things, period_s, dynamics)
        self.events = []
        self.told = WorldModel()
        self.toolbox = Toolbox(
            clock=self.fake.clock,
            model=model,
            motion=self.fake.motion,
            sensing=self.fake.sensing,
            grippers=self.fake.grippers,
            detector=self.fake.detector,
            planning=self.fake.planning,
            world=self.told,
            events=self.events.append,
            rng=np.random.default_rng(1),
            policy=replace(policy, looks_for_twins=looks_for_twins),
            walking=self.fake.walking if walks else None,
            yielding=self.fake.yielding if walks else None,
            ranging=self.fake.ranging if walks else None,
        )
        self.hooks = []
        self._found = {}
        self.fake.planning.motion_s = motion_s
        for gripper in self.fake.grippers.values():
            gripper.speed_rad_s *= HURRY
        self.fake.step()

    def ready(self, node, **inputs):
        """Wire a node, and write values to its input ports."""
        for item in node.iterate():
            if hasattr(item, "wire"):
                item.wire("/stage")
        wiring = getattr(node, "wiring", {})
        for port, value in inputs.items():
            Blackboard.set(f"/stage/{wiring.get(port, port)}", value)
        return node

    def output(self, name):
        return Blackboard.get(f"/stage/{name}")

    def place_y(self, name):
        """Where the world model has an object, to the left."""
        return self.told.scene.objects[name].world_T_object[1, 3]

    def tick(self, node):
        node.tick_once()
        self.fake.step()
        return node.status

    def run(self, node, limit=3000, **inputs):
        """Tick a node to its end."""
        self.ready(node, **inputs)
        for _ in range(limit):
            if self.tick(node) is not Status.RUNNING:
                return node.status
        raise AssertionError(f"{node.name} never ended: {node.feedback_message}")

    def pick(self, task=RED_CUP):
        return build_tree(task, self.toolbox)

    def when(self, where, act, after_ticks=0):
        """Do something once, some ticks after a node of that name began to run."""
        self.hooks.append([where, act, after_ticks])

    def play(self, tree, ticks=5000):
        """Tick a whole task to its end, or for some ticks."""
        for _ in range(ticks):
            if tree.status != "running":
                break
            tree.tick()
            self._run_hooks(tree)
            self.fake.step()
        assert tree.status == "running" or not self.hooks, f"never got there: {self.hooks}"
        return tree

    def _run_hooks(self, tree):
        if not self.hooks:
            return
        for hook in list(self.hooks):
            if any(node.status is Status.RUNNING for node in self._named(tree, hook[0])):
                hook[2] -= 1
                if hook[2] < 0:
                    self.hooks.remove(hook)
                    hook[1]()

    def _named(self, tree, name):
        """A tree's nodes of that name; going through all of them takes longer than a tick."""
        if (tree, name) not in self._found:
            self._found[tree, name] = [node for node in tree._nodes if node.name == name]
        return self._found[tree, name]

    def failed(self):
        return [event.failure for event in self.events if hasattr(event, "failure")]


@pytest.fixture(scope="session")
def model():
    return RobotModel(load_description("talos"))


@pytest.fixture(scope="session")
def new_stage(model):
    """Makes stages; whoever takes it clears the blackboard himself."""
    dynamics = StandingDynamics(StandingRobot(model, stance_at(model, model.q_home)))
    gestures, reached = RememberedGestures(model), {}

    def made(*objects, **options):
        stage = Stage(model, list(objects) or None, dynamics=dynamics, **options)
        stage.fake.planning.gestures, stage.fake.planning.reached = gestures, reached
        return stage

    return made


@pytest.fixture
def quick():
    """The policy of the stage: the same behavior as the product's, with shorter times."""
    return QUICK


@pytest.fixture
def stage(new_stage):
    yield new_stage()
    Blackboard.clear()


@pytest.fixture
def stage_with(new_stage):
    yield new_stage
    Blackboard.clear()


@pytest.fixture
def chain():
    """The links of a failure chain, from the top to the root cause."""

    def links(failure):
        found = []
        while failure is not None:
            found.append(failure)
            failure = failure.cause
        return found

    return links


@pytest.fixture
def probe_leaf():
    """A leaf whose steps are scripted; it notes how it is treated."""

    class Probe(Leaf, register=False):
        from trees.nodes.contract import Contract
        from trees.nodes.ports import ports

        INPUT_PORTS = ports()
        OUTPUT_PORTS = ports()
        CONTRACT = Contract("none", "none", deadline_s=1.0)

        def __init__(self, name, toolbox, *steps):
            super().__init__(name, toolbox)
            self.steps, self.script = list(steps), []
            self.released = []
            self.begun = 0

        def begin(self):
            self.begun += 1
            if not self.script:
                self.script = list(self.steps)

        def step(self):
            outcome = self.script.pop(0)
            if isinstance(outcome, Exception):
                raise outcome
            return outcome

        def release(self, reason):
            self.released.append(reason)

    return Probe


CUP_POSE = poses.translation(0.45, -0.2, 0.955)


@pytest.fixture
def target():
    return Target("red cup", "cup", "red", Cylinder(0.03, 0.11), CUP_POSE, 0.95)


@pytest.fixture
def knowing(stage, target):
    """The stage, with the red cup in the world model."""
    stage.told.update(stage.told.scene.with_object(SceneObject("red cup", target.shape, CUP_POSE, 0.01)))
    return stage


@pytest.fixture
def planned(knowing):
    """Grasp and steps of a pick, as the planner would give them."""
    fake, scene = knowing.fake, knowing.told.scene
    plan = fake.planning.answer(PickRequest(fake.motion.reference(), fake.motion.stance(), scene, "red cup"))

    class Planned:
        grasp = plan.grasp

        @staticmethod
        def step(name):
            step = getattr(plan, name)
            return Step(name, step.trajectory, step.scene, scene.version, step.concessions)

        @staticmethod
        def checked(name):
            step = getattr(plan, name)
            checked = fake.planning.verdict(step.question)
            return CheckedStep(name, checked, scene.version)

        @staticmethod
        def play(*names):
            """Bring the fake robot to the end of these steps."""
            for name in names:
                handle = fake.motion.start(Planned.checked(name).checked)
                while not handle.finished:
                    fake.step()
                assert handle.status.value == "done", handle.reason

        @staticmethod
        def grip():
            """Reach, approach, close: the fake hand holds the cup."""
            Planned.play("reach", "approach")
            handle = fake.grippers[plan.grasp.hand].close()
            while not handle.finished:
                fake.step()

    return Planned


@pytest.fixture
def right_grasp():
    return Grasp("right", "side", np.eye(4), 0.1, 0.06)


@pytest.fixture
def hold_level(stage):
    """Puts a solid into the left hand, its own axes along the world's."""

    def hold(shape):
        toolbox = stage.toolbox
        frame = toolbox.model.description.tcp_frames["left"]
        tcp_T_object = poses.inverse(toolbox.model.frame_pose(toolbox.sensing.state().q, frame))
        tcp_T_object[:3, 3] = 0.0
        scene = toolbox.world.scene.with_objects([SceneObject("blue box", shape, np.eye(4))])
        toolbox.world.update(scene.with_attached("blue box", frame, tcp_T_object, ()))

    return hold
