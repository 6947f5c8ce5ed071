"""Faults come in the phases that the tree really has, in places that a fault may use."""

import ast
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from kinematics.geometry import poses
from robots.models.description import load_description
from tools.evaluate.__main__ import main
from tools.evaluate.ailing.body_fault import struck_joint
from tools.evaluate.faults import CLOSE, FAULTS, LIFT, REACH, VERIFY, FaultBench, FaultState
from tools.evaluate.phases import PhaseWatch
from tools.evaluate.scenes import TARGET, pick_scene, read_episode_scene
from tools.evaluate.skills.faults import CARRYING, SKILL_FAULTS
from trees.events import NodeChanged

SKILLS = Path(__file__).parents[2] / "trees" / "skills"


class ScriptedWorld:
    """Truth and fault injector in one: time, places, and a list of what was done."""

    hands = ("left", "right")

    def __init__(self, scene):
        self.scene, self.time_s, self.done, self.waiting = scene, 0.0, [], []
        self.tilt, self.contacts = 0.0, self

    def world_T_object(self, name):
        return next(item.world_T_object for item in self.scene.objects if item.name == name)

    def world_T_tcp(self, hand):
        return poses.translation(0.16, 0.47 if hand == "left" else -0.47, 0.67)

    def objects(self):
        return tuple(item.name for item in self.scene.objects)

    def of_pads(self, name):
        return (SimpleNamespace(normal_n=20.0), SimpleNamespace(normal_n=20.0))

    def tilt_rad(self, name):
        return self.tilt

    def at(self, time_s, action):
        self.waiting.append((lambda: self.time_s >= time_s, action))

    def when(self, condition, action):
        self.waiting.append((condition, action))

    def advance_to(self, time_s):
        self.time_s = time_s
        due = [item for item in self.waiting if item[0]()]
        self.waiting = [item for item in self.waiting if item not in due]
        for _, action in due:
            action()

    def __getattr__(self, name):
        return lambda *details: self.done.append((name, *details))


def armed(fault, seed=0):
    scene = read_episode_scene(pick_scene(seed, fault if fault in FAULTS else None), seed)
    world, phases, state = ScriptedWorld(scene), PhaseWatch(), FaultState()
    perception = SimpleNamespace(errors=[], set_error=lambda *details: perception.errors.append(details))
    SKILL_FAULTS.get(fault, FAULTS.get(fault))(
        FaultBench(TARGET, scene, world, world, perception, phases, np.random.default_rng(seed)), state
    )
    return world, phases, state, perception


@pytest.mark.parametrize("phase", [REACH, CLOSE, LIFT, VERIFY, *CARRYING])
def test_the_tree_has_a_leaf_of_the_name_that_a_fault_waits_for(phase):
    words = {
        node.value
        for file in SKILLS.rglob("*.py")
        for node in ast.walk(ast.parse(file.read_text("utf-8")))
        if isinstance(node, ast.Constant)
    }

    assert phase in words


@pytest.mark.parametrize(
    ("fault", "phase", "deed"),
    [
        ("empty_grasp", CLOSE, {"remove"}),
        ("slip", LIFT, {"set_pad_friction"}),
        ("moved", REACH, {"displace"}),
        ("knocked", REACH, {"knock", "tip_over"}),
        ("taken", VERIFY, {"remove"}),
    ],
)
def test_a_fault_waits_for_its_phase_and_happens_once(fault, phase, deed):
    world, phases, state, _ = armed(fault)
    world.advance_to(50.0)
    assert not world.done

    phases.take(NodeChanged(50.0, f"pick/{phase}", "running", ""))
    world.advance_to(52.0)
    world.advance_to(60.0)

    assert state.fired
    ((name, target, *_),) = world.done
    assert name in deed
    assert target == TARGET


def test_a_moved_cup_ends_on_the_table_and_counts_as_recoverable_where_picks_are_promised():
    recoverable = 0
    for seed in range(20):
        world, phases, state, _ = armed("moved", seed)
        phases.take(NodeChanged(0.0, REACH, "running", ""))
        world.advance_to(2.0)
        ((_, _, offset),) = world.done
        place = world.world_T_object(TARGET)[:2, 3] + offset
        (table,) = world.scene.furniture
        assert 0.03 <= np.linalg.norm(offset) <= 0.10
        if state.recoverable:
            recoverable += 1
            assert np.all(np.abs(place - table.position_m) < 0.5 * np.array(table.size_m[:2]))
            assert 0.35 <= place[0] <= 0.65
            assert abs(place[1]) <= 0.45
    assert recoverable > 10


@pytest.mark.parametrize(("tilt", "recoverable"), [(0.0, True), (1.5, False)], ids=["stands", "lies"])
def test_a_knocked_cup_is_recoverable_when_it_ends_standing(tilt, recoverable):
    world, phases, state, _ = armed("knocked", 3)
    world.tilt = tilt
    phases.take(NodeChanged(0.0, REACH, "running", ""))
    world.advance_to(2.0)
    world.advance_to(3.5)

    assert state.recoverable == recoverable


def test_a_slipping_cup_gets_less_friction_than_its_grip_needs():
    for seed in range(10):
        world, phases, _, _ = armed("slip", seed)
        phases.take(NodeChanged(0.0, LIFT, "running", ""))
        world.advance_to(2.0)
        ((_, _, friction),) = world.done
        mass_kg = next(item.mass_kg for item in world.scene.objects if item.name == TARGET)
        assert 0.2 * mass_kg * 9.81 / 40.0 - 1e-9 <= friction < mass_kg * 9.81 / 40.0


def test_a_wrong_detection_is_four_centimetres_wrong():
    _, _, state, perception = armed("wrong_detection")

    ((kind, offset),) = perception.errors
    assert kind == "cup"
    assert np.linalg.norm(offset) == pytest.approx(0.04)
    assert state.recoverable


@pytest.mark.parametrize("fault", ["nothing_there", "too_close"])
def test_a_fault_of_the_scene_is_there_from_the_start(fault):
    world, _, state, _ = armed(fault)

    assert state.fired
    assert (TARGET in world.objects()) == (fault == "too_close")


@pytest.mark.parametrize("carrying", CARRYING)
def test_what_is_taken_on_the_way_is_taken_whichever_skill_carries_it(carrying):
    world, phases, state, _ = armed("taken_on_the_way")
    world.advance_to(1.0)
    assert not state.fired

    phases.take(NodeChanged(1.0, f"skill/{carrying}", "running", ""))
    world.advance_to(2.6)

    assert state.fired
    assert world.done == [("remove", TARGET)]


@pytest.mark.parametrize("words", [["wave", "--fault", "moved"], ["place", "--fault", "nothing_there"]])
def test_a_skill_takes_no_fault_that_cannot_come_in_it(words, capsys):
    assert main([*words, "--episodes", "1"]) == 2
    assert "takes no such fault" in capsys.readouterr().err


@pytest.mark.parametrize("robot", ["talos", "g1", "panda"])
def test_a_fault_strikes_a_joint_of_the_robot_that_is_there(robot):
    description = load_description(robot)

    struck = {struck_joint(description, np.random.default_rng(seed)) for seed in range(60)}

    assert len(struck) > 4
    assert struck <= {joint for joints in description.groups.values() for joint in joints}
