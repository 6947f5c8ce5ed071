"""Memory that was used before changes no answer."""

import numpy as np
import pytest

from kinematics.kernel import buffers
from kinematics.kernel.buffers import Buffers
from kinematics.kernel.collision_kernel import CollisionKernel
from kinematics.kernel.robot_arrays import humanoid_arrays
from kinematics.model.standing_robot import StandingRobot

HULLS = np.arange(6.0)


def soiled(arrays, seed):
    """A robot's memory of a problem that left nothing as it was."""
    floats, ints = arrays.buffers.take(80_000, 140_000)
    floats[len(arrays.hulls.floats) :] = -7e3
    ints[:] = np.random.default_rng(seed).integers(0, 4, len(ints))
    arrays.buffers.give_back(floats, ints)
    return floats


def answers(kernel, talos, space, at_random):
    """Distances, lines and a path, each question after the others."""
    rng = np.random.default_rng(5)
    points = [at_random.point(rng, talos, space) for _ in range(30)]
    home = space.from_q(talos.q_home)
    lines = [kernel.polyline_refusal(np.array([home, home + 0.3 * (point - home)])) for point in points]
    near = [kernel.distances_m(q) for q in space.to_q(np.array(points))[0]]
    margin = talos.description.planning_margin_rad
    columns = talos.indices(space.joints)
    lower = np.concatenate([points[0][:6] - 0.05, talos.lower_rad[columns] + margin])
    upper = np.concatenate([points[0][:6] + 0.05, talos.upper_rad[columns] - margin])
    goal = home.copy()
    goal[space.index("arm_right_1_joint")] -= 0.4
    way = kernel.connect(home, goal, lower, upper, space.weights, 0.5, 100, 3)
    return repr(lines), np.array(near).tobytes(), None if way is None else way.tobytes()


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("held", [False, True])
def test_a_judge_in_memory_that_was_used_answers_to_the_bit_as_one_in_fresh_memory(
    talos, stance, space, make, at_random, held, seed
):
    scene = at_random.scene(np.random.default_rng(2), talos, make, held=held)
    fresh = humanoid_arrays(talos)
    used = humanoid_arrays(talos)
    floats = soiled(used, seed)

    kernel = CollisionKernel.standing(used, StandingRobot(talos, stance), scene, 0.003)

    assert kernel._shared._packed.floats is floats
    expected = answers(
        CollisionKernel.standing(fresh, StandingRobot(talos, stance), scene, 0.003),
        talos,
        space,
        at_random,
    )
    assert answers(kernel, talos, space, at_random) == expected


def test_memory_comes_back_when_nobody_judges_by_it_any_longer(talos, stance, make, at_random):
    arrays = humanoid_arrays(talos)
    scene = at_random.scene(np.random.default_rng(2), talos, make)
    kernel = CollisionKernel.standing(arrays, StandingRobot(talos, stance), scene)
    other = kernel.allowing(scene.allowing([("held", "thing_0")]))
    memory = kernel._shared._packed.floats

    del kernel
    beside = CollisionKernel.standing(arrays, StandingRobot(talos, stance), scene)
    assert beside._shared._packed.floats is not memory
    del other

    assert (
        CollisionKernel.standing(arrays, StandingRobot(talos, stance), scene)._shared._packed.floats is memory
    )


def test_memory_that_is_too_small_is_not_handed_out():
    buffers = Buffers(HULLS)
    small = buffers.take(10, 10)
    buffers.give_back(*small)

    floats, ints = buffers.take(len(small[0]) + 1, 10)

    assert len(floats) > len(small[0])
    assert len(ints) >= 10
    assert np.array_equal(floats[: len(HULLS)], HULLS)


def test_memory_is_taken_back_when_the_interpreter_has_given_up_its_modules(monkeypatch):
    spare = Buffers(np.zeros(4))
    monkeypatch.setattr(buffers, "_KEPT", None)

    spare.give_back(*spare.take(8, 8))
