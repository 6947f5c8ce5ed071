import numpy as np
import pinocchio as pin

from kinematics.kernel import motion_bound

# what the compiler is given, without waiting for it
base_drift = motion_bound.base_drift.py_func


def turning(rng):
    """The middle of an interval, its ends, and the rotation vector's change in half of it."""
    middle, change = rng.normal(size=6) * rng.uniform(0.0, 1.2), rng.normal(size=6) * rng.uniform(0.0, 0.3)
    return middle, middle - change, middle + change, change


def angular_velocity(vector, change, step=1e-5):
    ahead, behind = (pin.exp3(vector + side * step * change) for side in (1.0, -1.0))
    return pin.log3(ahead @ behind.T) / (2.0 * step)


def test_the_bases_drift_is_its_velocity_in_the_middle_of_the_interval():
    rng = np.random.default_rng(0)
    for _ in range(100):
        middle, start, end, change = turning(rng)
        drift = np.empty(8)

        base_drift(middle, start, end, 0.5, drift)

        np.testing.assert_allclose(drift[:3], change[:3], atol=1e-12)
        np.testing.assert_allclose(drift[3:6], angular_velocity(middle[3:], change[3:]), atol=1e-8)


def test_nowhere_in_the_interval_does_it_turn_faster_or_otherwise_than_bounded():
    rng = np.random.default_rng(1)
    nearest = 0.0
    for _ in range(100):
        middle, start, end, change = turning(rng)
        drift = np.empty(8)
        base_drift(middle, start, end, 0.5, drift)
        for side in (-1.0, -0.5, 0.5, 1.0):
            there = angular_velocity(middle[3:] + side * change[3:], change[3:])

            assert np.linalg.norm(there) <= drift[6] * (1.0 + 1e-6)
            most = abs(side) * drift[6] ** 2 * drift[7]
            assert np.linalg.norm(there - drift[3:6]) <= most + 1e-9
            nearest = max(nearest, np.linalg.norm(there - drift[3:6]) / (most + 1e-9))
    assert nearest > 0.6
