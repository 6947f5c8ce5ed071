import numpy as np
import pinocchio as pin
import pytest

from kinematics.errors import ModelError
from kinematics.model.forward_kinematics import centre_of_mass, place_bodies
from kinematics.model.tree import tree_of


def random_tree(rng, joints=12):
    """Hinges and slides about aligned and oblique axes, branching, on placements turned at random."""
    model = pin.Model()
    kinds = [
        pin.JointModelRX, pin.JointModelRY, pin.JointModelRZ, pin.JointModelPX, pin.JointModelPZ,
        lambda: pin.JointModelRevoluteUnaligned(unit(rng)),
        lambda: pin.JointModelPrismaticUnaligned(unit(rng)),
    ]  # fmt: skip
    for k in range(joints):
        place = pin.SE3.Random() if k % 3 else pin.SE3(np.eye(3), rng.normal(size=3))
        parent = int(rng.integers(max(0, k - 3), k + 1))
        body = model.addJoint(parent, kinds[k % len(kinds)](), place, f"joint_{k}")
        model.appendBodyToJoint(body, pin.Inertia.Random(), pin.SE3.Identity())
    return model


def unit(rng):
    vector = rng.normal(size=3)
    return vector / np.linalg.norm(vector)


def agree(model, q):
    tree, data = tree_of(model), model.createData()
    R, p, com = np.empty((model.njoints, 3, 3)), np.empty((model.njoints, 3)), np.empty(3)
    place_bodies(tree, q, np.ones(model.njoints, np.int64), R, p)
    centre_of_mass(tree, R, p, com)
    pin.forwardKinematics(model, data, q)
    np.testing.assert_allclose(com, pin.centerOfMass(model, data, q), atol=1e-12)
    for body in range(model.njoints):
        np.testing.assert_allclose(R[body], data.oMi[body].rotation, atol=1e-12)
        np.testing.assert_allclose(p[body], data.oMi[body].translation, atol=1e-12)


def test_talos_agrees_with_pinocchio(talos):
    rng = np.random.default_rng(1)
    for _ in range(20):
        q = talos.q_home.copy()
        q[:3] = rng.normal(size=3)
        q[3:7] = rng.normal(size=4)
        q[3:7] /= np.linalg.norm(q[3:7])
        q[7:] = rng.uniform(talos.lower_rad, talos.upper_rad)
        agree(talos.pin, q)


@pytest.mark.parametrize("seed", range(5))
def test_any_welded_tree_of_hinges_and_slides_agrees_with_pinocchio(seed):
    rng = np.random.default_rng(seed)
    pin.seed(seed)
    model = random_tree(rng)
    for _ in range(5):
        agree(model, rng.uniform(-3.0, 3.0, model.nq))


def test_a_joint_of_more_than_one_number_is_refused():
    model = pin.Model()
    model.addJoint(0, pin.JointModelSpherical(), pin.SE3.Identity(), "ball")
    with pytest.raises(ModelError, match="ball"):
        tree_of(model)
