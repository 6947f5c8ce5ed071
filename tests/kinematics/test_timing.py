import socket

import numpy as np
import pytest

from kinematics.curves import RoundedPolyline
from kinematics.free_coordinates import FreeCoordinates
from kinematics.timing import Pace, time_curve


def random_curve(talos, stance, seed):
    rng = np.random.default_rng(seed)
    space = FreeCoordinates(talos, stance)
    start = space.from_q(talos.q_home)
    corners = [start]
    for _ in range(int(rng.integers(1, 4))):
        step = np.concatenate([rng.uniform(-0.02, 0.02, 6), rng.uniform(-0.4, 0.4, space.size - 6)])
        corners.append(start + step)
    return space, RoundedPolyline(np.array(corners), space.weights, 0.12)


@pytest.mark.parametrize("seed", range(8))
def test_every_joint_stays_inside_its_limits(talos, stance, seed):
    space, curve = random_curve(talos, stance, seed)

    trajectory = time_curve(talos, space, stance, curve, Pace())

    dt = np.diff(trajectory.t_s)[:, None]
    v = trajectory.v[:, 6:]
    acceleration = np.diff(v, axis=0) / dt
    jerk = np.diff(acceleration, axis=0) / dt[:-1]
    assert np.all(np.abs(v) <= talos.velocity * (1 + 1e-9))
    assert np.all(np.abs(acceleration) <= talos.acceleration * (1 + 1e-6))
    assert np.all(np.abs(jerk) <= talos.jerk * 1.02)
    assert np.all(trajectory.v[[0, -1]] == 0.0)


def test_velocities_are_the_derivative_of_the_configurations(talos, stance):
    import pinocchio as pin

    space, curve = random_curve(talos, stance, 1)
    trajectory = time_curve(talos, space, stance, curve, Pace())

    for k in range(10, len(trajectory.t_s) - 10, 7):
        dt = trajectory.t_s[k + 1] - trajectory.t_s[k - 1]
        numeric = pin.difference(talos.pin, trajectory.q[k - 1], trajectory.q[k + 1]) / dt
        assert trajectory.v[k] == pytest.approx(numeric, abs=5e-3)


def test_a_slower_pace_takes_longer_and_keeps_the_geometry(talos, stance):
    space, curve = random_curve(talos, stance, 2)

    fast = time_curve(talos, space, stance, curve, Pace())
    slow = time_curve(talos, space, stance, curve, Pace(velocity=0.2, acceleration=0.2))

    assert slow.duration_s > 1.5 * fast.duration_s
    assert slow.q[-1] == pytest.approx(fast.q[-1])


def test_legs_that_cannot_follow_give_no_trajectory(talos, stance):
    space = FreeCoordinates(talos, stance)
    start = space.from_q(talos.q_home)
    goal = start.copy()
    goal[2] += 0.3

    curve = RoundedPolyline(np.array([start, goal]), space.weights, 0.12)

    assert time_curve(talos, space, stance, curve, Pace()) is None


def test_timing_opens_no_socket(talos, stance, monkeypatch):
    def refuse(*arguments, **options):
        raise AssertionError("a socket was opened")

    monkeypatch.setattr(socket, "socket", refuse)
    space, curve = random_curve(talos, stance, 3)

    assert time_curve(talos, space, stance, curve, Pace()).duration_s > 0.0
