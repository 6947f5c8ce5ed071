"""Whatever happens to a leaf, it leaves the robot as its contract declares; for every leaf that exists.

Leaves are found in ``trees.leaves``, taken out of the trees of the skills that use them, and put on a
stage with the inputs and the posture that they had in a real run of the skill. A leaf is then halted at
each of its ticks, and everything around it fails, hangs, raises, is stale or is missing. Everything around
it is what it asks for or sets going when nothing is wrong: a fault of what a leaf never turns to is the
undisturbed run over again, tick by tick, and is left out.
"""

import contextlib
import functools
from pathlib import Path

import numpy as np
import pytest
from py_trees.blackboard import Blackboard
from py_trees.common import Status

from kinematics.requests.step import NoPlan
from robots.fake.fake_world import bowl, cup, person, table
from tests.trees.example_tasks import FURTHER, TASKS
from tests.trees.leaf_inputs import GIVEN
from trees.btcpp.leaf_kinds import known_leaves
from trees.btcpp.outside_leaves import outside_leaves
from trees.build import build_tree
from trees.failures import FailureKind
from trees.nodes.leaf import Leaf
from trees.registry import skills
from trees.tasks import HandOverTask, PickTask, PlaceTask

LEAVES = [leaf for leaf in known_leaves().values() if leaf.__module__.startswith("trees.")]
# Skills of other packages that are installed here are held to the same contract.
TREES = {type(task): skills()[task.action].tree for task in TASKS.values()}
LEAVES += [leaf for leaf in outside_leaves().leaves if leaf not in LEAVES]

LONGEST = 400
AFTERWARDS = 5
LONG_PERIOD_S = 0.25  # while something hangs, nothing happens but that time passes


def slips(stage):
    """After the lift the cup is gone: the skill recovers."""
    stage.when("verify lift", lambda: stage.fake.world.remove("red cup"))


def misses(stage):
    """The fingers miss: the skill backs out and tries again."""
    for gripper in stage.fake.grippers.values():
        gripper.empty = True


def fades(stage):
    """The hold is lost from sight: the skill puts the cup back."""
    stage.when("verify lift", lambda: stage.fake.detector.offset_m.update({"red cup": (0.0, 0.0, -0.2)}))


def pulls(stage):
    """The person takes what is offered, and has it."""
    stage.when("wait for the pull", lambda: stage.fake.pull_n.update(right=(6.0, 0.0, 0.0)), 10)
    stage.when("let it go", lambda: stage.fake.world.move("red cup", (0.3, 0.0, 0.25)))


def hits(stage):
    """Something is in the way of what is lowered: another spot is tried."""
    stage.when("lower", lambda: stage.fake.pull_n.update(right=(0.0, 0.0, 60.0)), 3)
    stage.when("lift it again", stage.fake.pull_n.clear)


# What goes wrong in the runs that contexts are taken from; nothing, where a skill is not named.
UPSETS = {
    PickTask: (lambda stage: None, slips, misses, fades),
    PlaceTask: (lambda stage: None, hits),
    HandOverTask: (pulls,),
}


def set_out(new_stage, **options):
    """A stage with something of everything, and motions in which a touch is felt on the way."""
    return new_stage(table(), cup(), bowl(), person(), motion_s=0.08, **options)


def leaves_asked_for(items):
    """The leaves that this session's tests are about; None when one of the tests is about all of them."""
    mine = [item for item in items if item.path == Path(__file__)]
    if not all(hasattr(item, "callspec") for item in mine):
        return None
    return {item.callspec.params.get("kind") for item in mine}


def skills_with(leaves, new_stage):
    """The skills that have one of these leaves; running all of them takes seconds."""
    if leaves is None:
        return list(TREES)
    toolbox = set_out(new_stage).toolbox
    return [kind for kind in TREES if leaves & _leaves_of(kind, toolbox)]


def _leaves_of(kind, toolbox):
    roots = [
        TREES[kind](TASKS[kind], toolbox),
        *(build_tree(task, toolbox).root for task in FURTHER.get(kind, ())),
    ]
    return {type(node) for root in roots for node in root.iterate()}


class Context:
    """What a leaf found when it began: how it was made, its task, inputs, posture and world."""

    def __init__(self, make, task, values, q, scene):
        self.make, self.task, self.values, self.q, self.scene = make, task, values, q, scene


class Makers:
    """Notes how leaves are made, so that one can be made again by itself: a whole tree takes 20 ms."""

    def __init__(self, patch):
        self._made = {}
        for kind in LEAVES:
            for base in kind.__mro__:
                own = vars(base).get("__init__")
                if own is not None and issubclass(base, Leaf) and not hasattr(own, "noted"):
                    patch.setattr(base, "__init__", self._noting(own))

    def _noting(self, init):
        @functools.wraps(init)
        def noted(leaf, *arguments, **named):
            self._made.setdefault(leaf, (arguments, named))
            init(leaf, *arguments, **named)

        noted.noted = True
        return noted

    def of(self, leaf):
        """Makes a leaf like this one, for another toolbox."""
        arguments, named = self._made[leaf]

        def make(toolbox):
            def exchanged(value):
                return toolbox if value is leaf.toolbox else value

            kept = [exchanged(value) for value in arguments]
            assert not any(map(callable, kept)), "it could act on the robot that it was made for"
            return type(leaf)(*kept, **{name: exchanged(value) for name, value in named.items()})

        return make


@pytest.fixture(scope="module")
def contexts(new_stage, request):
    with pytest.MonkeyPatch.context() as patch:
        makers = Makers(patch)
        return _contexts(new_stage, makers, skills_with(leaves_asked_for(request.session.items), new_stage))


def _contexts(new_stage, makers, kinds):
    """For each leaf class the context of its first beginning in any run; a richer posture wins."""
    found = {}
    for kind in kinds:
        task = TASKS[kind]
        upsets = [(task, upset) for upset in UPSETS.get(kind, (lambda stage: None,))]
        further = [(other, lambda stage: None) for other in FURTHER.get(kind, ())]
        for task, upset in (*upsets, *further):
            stage = set_out(new_stage)
            upset(stage)
            tree = build_tree(task, stage.toolbox)
            before = {type(node): node for node in tree.root.iterate() if isinstance(node, Leaf)}
            for leaf in before:
                q, scene = stage.fake.motion.reference(), stage.told.scene
                found.setdefault(leaf, Context(makers.of(before[leaf]), task, {}, q, scene))
            _follow(stage, tree, task, found, makers)
            Blackboard.clear()
    return found


def _follow(stage, tree, task, found, makers):
    leaves = [node for node in tree.root.iterate() if isinstance(node, Leaf)]
    for _ in range(LONGEST * 4):
        if tree.status != "running":
            return
        before, earlier = _ports(), stage.told.scene
        q = stage.fake.motion.reference()
        tree.tick()
        # What leaves before it in this very tick have seen counts; what it took away itself does not.
        scene = max(stage.told.scene, earlier, key=lambda scene: len(scene.objects))
        values = {**_ports(), **before}
        for node in leaves:
            if node.status is Status.INVALID:
                continue
            known = found[type(node)]
            if not known.values or (node.status is Status.RUNNING and not hasattr(known, "ran")):
                found[type(node)] = Context(makers.of(node), task, values, q, scene)
                if node.status is Status.RUNNING:
                    found[type(node)].ran = True
        stage._run_hooks(tree)
        stage.fake.step()


def _ports():
    return {key.rsplit("/", 1)[-1]: value for key, value in Blackboard.storage.items()}


class Trial:
    """One leaf on a fresh stage, and what it does to the robot."""

    def __init__(self, stage, kind, context):
        self.stage, self.kind = stage, kind
        stage.fake.motion._q = context.q.copy()
        if context.scene.version > stage.told.scene.version:
            stage.told.update(context.scene)
        stage.fake.step()
        given = GIVEN[kind](stage) if kind in GIVEN else {}
        self.leaf = context.make(stage.toolbox)
        stage.ready(self.leaf)
        wired = {self.leaf.wiring.get(port, port): value for port, value in given.items()}
        for key, value in {**context.values, "task": context.task, **wired}.items():
            Blackboard.set(f"/stage/{key}", value)
        self.body = stage.fake.motion.reference()
        self.fingers = self.finger_positions()
        self.started = len(stage.fake.motion.started)
        self.ticks = 0

    def finger_positions(self):
        return [gripper.position_rad for gripper in self.stage.fake.grippers.values()]

    def note_what_it_turns_to(self):
        """Notes from now on in ``turned_to`` which parts of the robot the leaf asks or sets going."""
        self.turned_to = set()
        for part, item, names in parts_of(self.stage.fake):
            for name in names:
                setattr(item, name, self._noting(part, getattr(item, name)))

    def _noting(self, part, function):
        def noted(*arguments):
            self.turned_to.add(part)
            return function(*arguments)

        return noted

    def run(self, ticks=LONGEST):
        """Tick until the leaf ends, or so often."""
        for _ in range(ticks):
            self.ticks += 1
            if self.stage.tick(self.leaf) is not Status.RUNNING:
                return

    def halt(self):
        self.leaf.halt_reason = "by the test"
        self.leaf.stop(Status.INVALID)

    def require_kept(self):
        """The robot is stopped or holding, and nothing moved that the leaf does not declare to move."""
        fake, moves = self.stage.fake, self.kind.CONTRACT.moves
        assert not fake.motion.moving, "something is still under way"
        assert all(job.canceled or job.done for job in fake.planning.jobs), "a job was left behind"
        q, fingers = fake.motion.reference(), self.finger_positions()
        for _ in range(AFTERWARDS):
            fake.step()
        np.testing.assert_array_equal(fake.motion.reference(), q, "the body moves on")
        assert self.finger_positions() == fingers, "the fingers move on"
        if "body" not in moves:
            np.testing.assert_array_equal(q, self.body, "the body was moved by a leaf that moves none")
        if "gripper" not in moves:
            assert fingers == self.fingers, "the fingers were moved by a leaf that moves none"
        if moves == "nothing":
            assert len(fake.motion.started) == self.started, "something was set in motion"

    def require_failed(self, *kinds):
        assert self.leaf.status is Status.FAILURE
        assert self.leaf.failure is not None
        assert self.leaf.failure.message
        if kinds:
            assert self.leaf.failure.kind in kinds, self.leaf.failure
        self.require_kept()


def parts_of(fake):
    """What a leaf can turn to: a part's name, its objects, and all their functions that a fault may touch."""
    for part, objects in (
        ("planning", (fake.planning,)),
        ("motion", (fake.motion,)),
        ("gripper", tuple(fake.grippers.values())),
        ("camera", (fake.detector,)),
        ("sensing", (fake.sensing,)),
        ("legs", (fake.walking,)),
        ("yielding", (fake.yielding,)),
        ("ranging", (fake.ranging,)),
    ):
        for item in objects:
            public = {name for name in dir(item) if not name.startswith("_")} - UNTOUCHED
            yield part, item, [name for name in sorted(public) if callable(getattr(item, name))]


# What the fake world itself calls, and what no fault changes.
UNTOUCHED = {
    *("advance", "add", "answer", "reference", "acceleration", "stance", "cancel"),
    *("note", "feet", "step_by", "unwalked", "be_at", "reach"),
}


@pytest.fixture(scope="module")
def undisturbed(new_stage, contexts):
    """Gives a run of a leaf to its end while nothing is wrong; made once."""

    @functools.cache
    def run_of(kind, **options):
        run = Trial(set_out(new_stage, walks=True, **options), kind, contexts[kind])
        run.note_what_it_turns_to()
        run.run()
        Blackboard.clear()
        return run

    return run_of


@pytest.fixture(scope="module")
def turned_to(undisturbed):
    """Tells which parts of the robot a leaf turns to while nothing is wrong, however long a tick is."""

    def parts(kind):
        return undisturbed(kind).turned_to | undisturbed(kind, period_s=LONG_PERIOD_S).turned_to

    return parts


@contextlib.contextmanager
def noted_as(fault):
    """What fails in here says with which fault."""
    try:
        yield
    except BaseException as error:
        error.add_note(f"with the fault {fault.__name__}")
        raise


@pytest.fixture
def trial(new_stage, contexts):
    def made(kind, **options):
        return Trial(set_out(new_stage, walks=True, **options), kind, contexts[kind])

    yield made
    Blackboard.clear()


def test_every_leaf_is_used_by_a_skill(contexts):
    assert not [leaf.__name__ for leaf in LEAVES if leaf not in contexts]


every_leaf = pytest.mark.parametrize("kind", LEAVES, ids=lambda kind: kind.__name__)


@pytest.mark.requirement("S7")
@every_leaf
def test_a_leaf_halted_at_any_of_its_ticks_leaves_the_robot_at_rest(trial, undisturbed, kind):
    for at in range(1, undisturbed(kind).ticks):
        halted = trial(kind)
        halted.run(at)
        halted.halt()

        assert halted.leaf.status is Status.INVALID
        assert halted.leaf.failure.kind is FailureKind.CANCELED
        assert halted.leaf.failure.message == "by the test"
        halted.require_kept()


@every_leaf
def test_a_leaf_that_runs_undisturbed_ends_and_leaves_the_robot_at_rest(undisturbed, kind):
    run = undisturbed(kind)

    assert run.leaf.status is not Status.RUNNING
    if run.leaf.status is Status.SUCCESS:
        assert run.leaf.failure is None
    else:
        # one that ends at its first missing input meets none of the faults: give it some in leaf_inputs
        assert run.leaf.failure.kind is not FailureKind.ERROR, run.leaf.failure
    run.require_kept()


def no_plan(fake):
    fake.planning.no_plan = NoPlan("no goal", {})


def motion_refused(fake):
    fake.motion.refuse = "the emergency stop is engaged: by the test"


def motion_refused_midway(fake):
    fake.motion.refuse_midway = "position limit of arm_left_2_joint"


def blind(fake):
    fake.detector.blind = True


def empty_hand(fake):
    for gripper in fake.grippers.values():
        gripper.empty = True


walk_refused = lead_refused = motion_refused
walk_refused_midway = lead_refused_midway = motion_refused_midway


def scans_cease(fake):
    scans = iter([fake.ranging.scan()])
    fake.ranging.scan = lambda: next(scans, None)


FAILING = {
    no_plan: "planning",
    motion_refused: "motion",
    motion_refused_midway: "motion",
    blind: "camera",
    empty_hand: "gripper",
    walk_refused: "legs",
    walk_refused_midway: "legs",
    lead_refused: "yielding",
    lead_refused_midway: "yielding",
    scans_cease: "ranging",
}


@pytest.mark.requirement("S7")
@every_leaf
def test_a_leaf_around_which_something_fails_ends_and_leaves_the_robot_at_rest(trial, turned_to, kind):
    for fault in meeting(turned_to(kind), FAILING):
        with noted_as(fault):
            run = trial(kind)
            fault(run.stage.fake)
            run.run()

            assert run.leaf.status is not Status.RUNNING
            run.require_kept()


def meeting(parts, faults):
    """Those of the faults that a leaf meets which turns to these parts of the robot."""
    return [fault for fault, part in faults.items() if part in parts]


def planning_hangs(fake):
    fake.planning.hangs = True


def motion_hangs(fake):
    fake.motion.advance = lambda: None


def fingers_hang(fake):
    for gripper in fake.grippers.values():
        gripper.speed_rad_s = 0.0


def camera_hangs(fake):
    fake.detector.frozen = True


def legs_hang(fake):
    fake.walking.hangs = True


def yielding_hangs(fake):
    fake.yielding.hangs = True


def nothing_is_scanned(fake):
    fake.ranging.silent = True


HANGING = {
    planning_hangs: "planning",
    motion_hangs: "motion",
    fingers_hang: "gripper",
    camera_hangs: "camera",
    legs_hang: "legs",
    yielding_hangs: "yielding",
    nothing_is_scanned: "ranging",
}


@pytest.mark.requirement("S7")
@every_leaf
def test_a_leaf_that_hangs_gives_up_at_its_deadline_and_leaves_the_robot_at_rest(trial, turned_to, kind):
    for fault in meeting(turned_to(kind), HANGING):
        with noted_as(fault):
            run = trial(kind, period_s=LONG_PERIOD_S)
            fault(run.stage.fake)
            began_s = run.stage.fake.clock.now_s()
            run.run(round((run.leaf.deadline_s + 2.0) / LONG_PERIOD_S))

            assert run.leaf.status is not Status.RUNNING
            assert run.stage.fake.clock.now_s() - began_s <= run.leaf.deadline_s + 2 * LONG_PERIOD_S
            if run.leaf.status is Status.FAILURE:
                run.require_failed()
            run.require_kept()


class Boom:
    """A call that fails, and knows whether anybody made it."""

    def __init__(self):
        self.made = False

    def __call__(self, *_arguments):
        self.made = True
        raise OSError("the cable is out")


def planning_raises(fake, boom):
    fake.planning.answer = boom


def submitting_raises(fake, boom):
    fake.planning.submit = boom


def starting_raises(fake, boom):
    fake.motion.start = boom


def gripper_raises(fake, boom):
    for gripper in fake.grippers.values():
        gripper.open = gripper.close = gripper.reading = boom


def camera_raises(fake, boom):
    fake.detector.latest = boom


def sensing_raises(fake, boom):
    fake.sensing.state = fake.sensing.state_at = boom


def walking_raises(fake, boom):
    fake.walking.walk = boom


def yielding_raises(fake, boom):
    fake.yielding.start = boom


def scanning_raises(fake, boom):
    fake.ranging.scan = boom


RAISING = {
    planning_raises: "planning",
    submitting_raises: "planning",
    starting_raises: "motion",
    gripper_raises: "gripper",
    camera_raises: "camera",
    sensing_raises: "sensing",
    walking_raises: "legs",
    yielding_raises: "yielding",
    scanning_raises: "ranging",
}


@pytest.mark.requirement("S8")
@every_leaf
def test_what_raises_becomes_the_leafs_failure_and_the_robot_is_at_rest(trial, turned_to, kind):
    # without states there are no new pictures either: no leaf's undisturbed run over again
    for fault in meeting(turned_to(kind) | {"sensing"}, RAISING):
        with noted_as(fault):
            run, boom = trial(kind), Boom()
            fault(run.stage.fake, boom)
            run_without_sensing(run)
            require_the_cause_told(run, met=boom.made)


def run_without_sensing(run):
    """Tick it to its end in a world that keeps no states, which would raise by itself."""
    for _ in range(LONGEST):
        run.leaf.tick_once()
        if run.leaf.status is not Status.RUNNING:
            break
        run.stage.fake.clock.advance(0.02)
        run.stage.fake.motion.advance()
        run.stage.fake.walking.advance()
        run.stage.fake.yielding.advance()
        for gripper in run.stage.fake.grippers.values():
            gripper.advance(0.02)


def require_the_cause_told(run, met):
    """What a leaf meets that raises is its failure: one that swallows it would call its work done."""
    assert run.leaf.status is not Status.RUNNING
    assert not run.stage.fake.motion.moving
    if met:
        assert run.leaf.status is Status.FAILURE, "what it turned to had raised"
        assert "the cable is out" in run.leaf.failure.message


def test_every_fault_is_met_by_some_leaf(turned_to):
    met = set().union(*(turned_to(kind) for kind in LEAVES))

    assert met == {part for faults in (FAILING, HANGING, RAISING) for part in faults.values()}


@pytest.mark.parametrize("fault", RAISING)
def test_every_call_that_raises_is_made_by_some_leaf(trial, turned_to, fault):
    def makes_it(kind):
        run, boom = trial(kind), Boom()
        fault(run.stage.fake, boom)
        run_without_sensing(run)
        return boom.made

    assert any(makes_it(kind) for kind in LEAVES if RAISING[fault] in turned_to(kind))


@pytest.mark.requirement("S8")
@every_leaf
def test_a_leaf_without_one_of_its_inputs_fails_and_moves_nothing(trial, kind):
    for port, information in kind.INPUT_PORTS.items():
        run = trial(kind)
        key = f"/stage/{run.leaf.wiring.get(port, port)}"
        if Blackboard.exists(key):
            Blackboard.unset(key)
        run.run()

        if information.required and not information.has_default:
            run.require_failed(FailureKind.ERROR)
        else:
            assert run.leaf.status is not Status.RUNNING
            run.require_kept()


@pytest.mark.requirement("S7")
@every_leaf
def test_a_world_that_changes_under_a_leaf_leaves_the_robot_at_rest(trial, kind):
    run = trial(kind)
    run.run(1)
    scene = run.stage.told.scene
    run.stage.told.update(scene.allowing([("a", "b")]))
    run.run()

    assert run.leaf.status is not Status.RUNNING
    run.require_kept()
