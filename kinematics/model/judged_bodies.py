"""Which joints and collision solids a robot may have, so that whatever is planned for it can be judged.

The trajectory checker proves motions of hinges, and of boxes, cylinders, balls and convex hulls. The
planner could do with more; a robot of which a plan could not be judged is refused when it is loaded.
"""

from __future__ import annotations

from xml.etree import ElementTree

import coal
import numpy as np
import pinocchio as pin

from kinematics.errors import ModelError

_FIRST_JOINT = 2
_KINDS = (coal.Box, coal.Cylinder, coal.Sphere, coal.ConvexBase)


def require_hinges(robot: str, tree: pin.Model) -> None:
    """Refuse a body joint that is not a hinge with limits.

    Args:
        robot: Its name.
        tree: With the floating base first.

    Raises:
        ModelError: A joint slides, turns without end, or is of several numbers.
    """
    for name, joint in list(zip(tree.names, tree.joints, strict=True))[_FIRST_JOINT:]:
        subspace = np.array(joint.createData().S).reshape(6, -1)
        if subspace.shape[1] != 1 or (subspace[:3].any() and subspace[3:].any()):
            what = "is no hinge"
        elif subspace[:3].any():
            what = "slides"
        elif joint.nq != 1:
            what = "turns without end, and needs limits"
        else:
            continue
        raise ModelError(f"{robot}: joint {name!r} {what}; body joints are hinges, only grippers' may slide")


def require_no_capsules(robot: str, urdf: str) -> None:
    """Refuse a URDF that has cylinders rounded off to capsules (``<collision_checking>``).

    Raises:
        ModelError: It has one.
    """
    for link in ElementTree.fromstring(urdf).iter("link"):
        if link.find("collision_checking/capsule") is not None:
            raise ModelError(
                f"{robot}: link {link.get('name')!r} has a capsule; collision solids are boxes, cylinders, "
                "spheres and meshes, so leave <collision_checking> out"
            )


def require_judged_solids(robot: str, geometry: pin.GeometryModel) -> None:
    """Refuse a collision solid that the checker has no distance for.

    Raises:
        ModelError: It is no box, cylinder, ball or convex hull.
    """
    for item in geometry.geometryObjects:
        if not isinstance(item.geometry, _KINDS):
            raise ModelError(
                f"{robot}: {item.name!r} is a {type(item.geometry).__name__}; collision solids are boxes, "
                "cylinders, spheres and meshes"
            )
