import numpy as np
import pinocchio as pin

from kinematics.check_poses import CompiledKinematics
from kinematics.check_timeline import Configurations, rotations


def test_the_checkers_efforts_are_those_of_pinocchios_inverse_dynamics(talos):
    rng = np.random.default_rng(3)
    q = np.array(
        [pin.integrate(talos.pin, talos.q_home, 0.3 * rng.standard_normal(talos.nv)) for _ in range(9)]
    )
    v, a = rng.standard_normal((2, 9, talos.nv))
    kinematics = CompiledKinematics(talos)
    at = Configurations(np.zeros(9), q[:, :3], q[:, 3:7], rotations(q[:, 3:7]), q[:, 7:])

    efforts = kinematics.efforts(kinematics.poses(at), v, a)

    data = talos.pin.createData()
    expected = [pin.rnea(talos.pin, data, *row) for row in zip(q, v, a, strict=True)]
    np.testing.assert_allclose(efforts, expected, atol=1e-9)
