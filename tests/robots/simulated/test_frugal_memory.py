"""A world in which nobody takes pictures is the same world, and small."""

import subprocess
import sys

import mujoco
import numpy as np
import pytest

from robots.models.description import load_robot
from robots.scenes.scene_file import load_scene
from robots.simulated.world import build_world

MOST_MIB = 200
LEAST_LET_GO_MIB = 20.0
SAME = ("body_mass", "body_inertia", "body_ipos", "dof_damping", "jnt_range", "actuator_gainprm", "qpos0")


def world(*, drawn):
    return build_world(load_robot("talos"), load_scene("tabletop"), np.random.default_rng(0), drawn=drawn)


@pytest.fixture(scope="module")
def worlds():
    return world(drawn=True), world(drawn=False)


@pytest.mark.parametrize("name", SAME)
def test_what_is_only_drawn_weighs_nothing(worlds, name):
    one, other = (getattr(some.physics.model, name) for some in worlds)

    assert np.array_equal(one, other)


def test_meshes_for_pictures_are_most_of_a_world(worlds):
    drawn, undrawn = (mujoco.mj_sizeModel(some.physics.model) for some in worlds)

    assert undrawn < 0.5 * drawn


def test_a_robot_that_nobody_draws_moves_as_one_that_is_drawn(worlds):
    for one in worlds:
        for _ in range(200):
            one.robot.advance(0.002)

    first, second = (some.physics.data.qpos for some in worlds)
    assert np.array_equal(first, second)


FRUGAL = """
import pathlib
import numpy as np
from robots.models.description import load_robot
from robots.scenes.scene_file import load_scene
from robots.simulated.frugal_memory import be_frugal, give_back
from robots.simulated.world import build_world
robot, scene = load_robot("talos"), load_scene("tabletop")
be_frugal()
for _ in range(4):
    world = build_world(robot, scene, np.random.default_rng(0), drawn=False)
    del world
    give_back(garbage=True)
status = pathlib.Path("/proc/self/status").read_text()
print(int(status.partition("VmHWM:")[2].split()[0]) // 1024)
"""


LET_GO = """
import pathlib
import numpy as np
import numba
from robots.simulated.frugal_memory import let_go_of_compilers

@numba.njit
def doubled(a):
    return 2.0 * a

def resident_mib():
    return int(pathlib.Path("/proc/self/status").read_text().partition("RssFile:")[2].split()[0]) / 1024.0

assert doubled(np.ones(3))[0] == 2.0
before = resident_mib()
let_go_of_compilers()
let_go = before - resident_mib()
assert doubled(np.ones((3, 1)))[0, 0] == 2.0  # another signature: the compiler is wanted again
print(let_go)
"""


def test_a_compiler_that_is_let_go_of_is_there_when_it_is_wanted_again():
    found = subprocess.run([sys.executable, "-c", LET_GO], capture_output=True, text=True, check=True)

    assert float(found.stdout) > LEAST_LET_GO_MIB


def test_worlds_one_after_the_other_do_not_add_up():
    found = subprocess.run([sys.executable, "-c", FRUGAL], capture_output=True, text=True, check=True)

    assert int(found.stdout) <= MOST_MIB
