import numpy as np
import pinocchio as pin

from kinematics.stance import SupportPolygon
from kinematics.trajectory_sampler import MotionSample
from kinematics.zmp import balance_margins_m


def test_the_zmp_is_where_the_rate_of_the_whole_bodys_momentum_puts_it(talos, stance):
    rng = np.random.default_rng(3)
    q = np.array(
        [pin.integrate(talos.pin, talos.q_home, 0.2 * rng.standard_normal(talos.nv)) for _ in range(9)]
    )
    v, a = rng.standard_normal((2, 9, talos.nv))

    zmp_m, com_m = balance_margins_m(talos, stance, MotionSample(q, v, a))

    polygon, data = SupportPolygon(stance, talos.description.soles), talos.pin.createData()
    weight = 9.81 * pin.computeTotalMass(talos.pin)
    for k in range(9):
        pin.computeCentroidalMomentumTimeVariation(talos.pin, data, q[k], v[k], a[k])
        x, y, z = data.com[0]
        (fx, fy, fz), (mx, my, _) = data.dhg.linear, data.dhg.angular
        there = np.array([x - (z * fx + my) / (fz + weight), y - (z * fy - mx) / (fz + weight)])
        np.testing.assert_allclose(zmp_m[k], polygon.com_margin_m(there), atol=1e-9)
        np.testing.assert_allclose(com_m[k], polygon.com_margin_m(np.array([x, y])), atol=1e-12)
