import numpy as np
import pinocchio as pin
import pytest

from kinematics.dynamics.zmp import balance_margins_m
from kinematics.geometry import poses
from kinematics.model.stance import Stance
from kinematics.model.standing_robot import StandingRobot
from kinematics.model.support_polygon import SupportPolygon
from kinematics.motion.sampler import MotionSample


def test_the_zmp_is_where_the_rate_of_the_whole_bodys_momentum_puts_it(talos, stance):
    rng = np.random.default_rng(3)
    q = np.array(
        [pin.integrate(talos.pin, talos.q_home, 0.2 * rng.standard_normal(talos.nv)) for _ in range(9)]
    )
    v, a = rng.standard_normal((2, 9, talos.nv))

    zmp_m, com_m = balance_margins_m(StandingRobot(talos, stance), MotionSample(q, v, a))

    polygon, data = SupportPolygon(stance, talos.description.soles), talos.pin.createData()
    weight = 9.81 * pin.computeTotalMass(talos.pin)
    for k in range(9):
        pin.computeCentroidalMomentumTimeVariation(talos.pin, data, q[k], v[k], a[k])
        x, y, z = data.com[0]
        (fx, fy, fz), (mx, my, _) = data.dhg.linear, data.dhg.angular
        there = np.array([x - (z * fx + my) / (fz + weight), y - (z * fy - mx) / (fz + weight)])
        np.testing.assert_allclose(zmp_m[k], polygon.com_margin_m(there), atol=1e-9)
        np.testing.assert_allclose(com_m[k], polygon.com_margin_m(np.array([x, y])), atol=1e-12)


@pytest.mark.parametrize("compiled", [True, False])
def test_on_a_platform_the_zmp_is_on_the_plane_of_the_soles(talos, stance, monkeypatch, compiled):
    monkeypatch.setattr("kinematics.dynamics.zmp.readiness.usable", lambda: compiled)
    rng = np.random.default_rng(4)
    q = np.tile(talos.q_home, (5, 1))
    v, a = rng.standard_normal((2, 5, talos.nv))
    raised = Stance(tuple((frame, poses.translation(0.0, 0.0, 0.1) @ pose) for frame, pose in stance.soles))
    q_raised = q.copy()
    q_raised[:, 2] += 0.1

    on_floor, _ = balance_margins_m(StandingRobot(talos, stance), MotionSample(q, v, a))
    on_platform, _ = balance_margins_m(StandingRobot(talos, raised), MotionSample(q_raised, v, a))

    np.testing.assert_allclose(on_platform, on_floor, atol=1e-9)
