"""Where the ground would have to push: the zero-moment point along a motion of a standing robot.

From the whole body's momentum and its rate; Kajita et al., "Introduction to Humanoid Robotics",
Springer 2014, section 3.3.
"""

from __future__ import annotations

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from kinematics.robot_model import RobotModel
from kinematics.stance import SupportPolygon
from kinematics.trajectory import Stance
from kinematics.trajectory_sampler import MotionSample

Array = NDArray[np.float64]

_GRAVITY_M_S2 = 9.81


def balance_margins_m(model: RobotModel, stance: Stance, motion: MotionSample) -> tuple[Array, Array]:
    """Distances of ZMP and CoM to the edge of the support polygon, positive inside.

    Args:
        model: The robot.
        stance: Where its soles stand.
        motion: Instants of a motion, arrays with k rows.

    Returns:
        Margins of the ZMP and of the CoM's ground projection, shape (k,) each, m; infinite for a
        welded robot.
    """
    polygon = SupportPolygon(stance, model.description.soles)
    data = model.pin.createData()
    mass = float(pin.computeTotalMass(model.pin))
    zmp, com = np.empty((len(motion.q), 2)), np.empty((len(motion.q), 2))
    for k in range(len(motion.q)):
        pin.computeCentroidalMomentumTimeVariation(model.pin, data, motion.q[k], motion.v[k], motion.a[k])
        (fx, fy, fz), (mx, my, _) = data.dhg.linear.tolist(), data.dhg.angular.tolist()
        x, y, z = data.com[0].tolist()
        up = max(fz + mass * _GRAVITY_M_S2, 1e-6)
        com[k] = x, y
        zmp[k] = x - (z * fx + my) / up, y - (z * fy - mx) / up
    return polygon.margins_m(zmp), polygon.margins_m(com)
