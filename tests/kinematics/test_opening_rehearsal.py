import numpy as np

from kinematics import poses
from kinematics.opening_rehearsal import com_shift_m
from kinematics.trajectory import Stance


def test_a_pull_tips_a_robot_on_a_platform_as_it_does_on_the_floor(talos, stance):
    raised = Stance(tuple((frame, poses.translation(0.0, 0.0, 0.1) @ pose) for frame, pose in stance.soles))
    outward = np.array([-1.0, 0.0, 0.0])

    on_floor = com_shift_m(talos, stance, outward, 1.0, 40.0)

    np.testing.assert_allclose(com_shift_m(talos, raised, outward, 1.1, 40.0), on_floor, atol=1e-12)
