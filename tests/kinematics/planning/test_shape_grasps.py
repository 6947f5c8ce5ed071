from dataclasses import replace

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.convex_parts import ConvexParts
from kinematics.geometry.shapes import Box
from kinematics.model.robot_model import RobotModel
from kinematics.planning import shape_grasps as module
from kinematics.planning.grasps_of_shapes import any_grasp_table, no_grasp_reason
from kinematics.planning.shape_grasps import shape_grasps
from kinematics.scene.planning_scene import SceneObject
from robots.models.description import load_description
from robots.simulated.floating_hand import holds
from tests import foreign_meshes as foreign
from tests.kinematics.planning.conftest import as_wide_as, thing


def cup_that_widens(rng):
    radius, height = rng.uniform(0.03, 0.04), rng.uniform(0.08, 0.13)
    foot = radius * rng.uniform(0.55, 0.75)
    return foreign.lathe([(0, 0), (foot, 0), (radius, height), (0, height)])


@pytest.fixture(scope="module")
def gripper(talos):
    return talos.description.grippers["right"]


@pytest.mark.parametrize("seed", range(6))
def test_the_first_grasp_holds_though_the_pose_is_5_mm_and_3_degrees_wrong(seed, gripper, talos):
    rng = np.random.default_rng(seed)
    mesh = (
        foreign.bottle(rng.uniform(0.026, 0.037), rng.uniform(0.16, 0.24))
        if seed % 2
        else cup_that_widens(rng)
    )
    parts = thing(mesh, f"held {seed}").parts
    turn, shift = rng.normal(size=3), rng.normal(size=3)
    wrong = poses.transform(
        poses.rotation_from_vector(np.radians(3.0) * turn / np.linalg.norm(turn)),
        0.005 * shift / np.linalg.norm(shift),
    )

    found = shape_grasps(parts, talos, "right", np.eye(4))

    assert holds(parts, found.object_T_tcp[0] @ wrong, gripper.max_opening_m, (0.029, 0.016))


@pytest.mark.parametrize("seed", range(3))
def test_what_is_between_the_pads_has_the_width_that_is_told_and_its_sides_face_them(seed, gripper, talos):
    rng = np.random.default_rng(seed)
    parts = thing(foreign.pebble(rng, 0.045), f"stone {seed}").parts

    found = shape_grasps(parts, talos, "right", np.eye(4))

    for pose, opening in list(zip(found.object_T_tcp, found.opening_m, strict=True))[:40]:
        x, y, z = ((parts.surface - pose[:3, 3]) @ pose[:3, :3]).T
        between = y[(np.abs(x) < 0.029) & (np.abs(z) < 0.05)]
        assert np.ptp(between) <= opening + 0.002
        assert abs(between.max() + between.min()) < 0.004
        assert gripper.least_felt_m <= opening <= gripper.max_opening_m - 0.012
        assert pose[2, 0] < 0.1  # never from below


@pytest.mark.parametrize("height", [0.12, 0.16, 0.22])
def test_a_single_finger_meets_what_the_outer_two_of_the_other_side_meet(height, gripper, talos):
    parts = thing(foreign.bottle(0.023, height), f"slim bottle {height}").parts
    half_long, narrow = 0.029, min(half[0] for half in gripper.pad_half_size_m)

    found = shape_grasps(parts, talos, "right", np.eye(4))

    assert len(found.cost)
    for pose in found.object_T_tcp:
        x, y, z = ((parts.surface - pose[:3, 3]) @ pose[:3, :3]).T
        between = (np.abs(x) < half_long) & (np.abs(z) < gripper.fingers_half_width_m)
        middle = y[between & (np.abs(z) < narrow)]
        assert middle.min() < y[between].min() + 0.004
        assert middle.max() > y[between].max() - 0.004


def test_a_thing_held_beside_its_middle_is_told_to_be_off_centre(talos):
    # a flag on a pole, which alone is between the pads
    pole, flag = foreign.carton((0.04, 0.04, 0.2)), foreign.carton((0.09, 0.1, 0.03))
    flag.apply_translation((0.0, 0.05, 0.085))
    mesh = foreign.trimesh.util.concatenate([pole, flag])
    parts = thing(mesh, "flag").parts

    found = shape_grasps(parts, talos, "right", np.eye(4))

    assert len(found.cost)
    for pose, off in zip(found.object_T_tcp, found.off_centre_m, strict=True):
        assert off == pytest.approx((np.linalg.inv(pose) @ [0, 0, 0, 1])[1], abs=1e-9)
    assert np.abs(found.off_centre_m).max() > 0.01


def test_a_table_of_it_has_the_columns_of_one_by_an_outline_and_turns_with_the_thing(talos):
    shape = thing(foreign.bottle(), "bottle")
    pose = poses.transform(poses.rotation_z(0.7), (0.5, -0.2, 0.96))

    table = any_grasp_table(SceneObject("bottle", shape, pose), talos, "right", 0.1, 0.1, (0.12,), 0.5)

    assert np.all(np.diff(table.cost) >= 0.0)
    assert table.cost[0] >= 0.5
    assert len({table.name(row) for row in range(len(table))}) == len(table)
    grasp = table.candidate(0).grasp
    assert grasp.hand == "right"
    assert np.linalg.norm(grasp.world_T_tcp[:2, 3] - pose[:2, 3]) < 0.03


def test_what_fits_its_outline_is_grasped_by_that(talos):
    shape = thing(foreign.can(), "can")
    item = SceneObject("can", shape, poses.translation(0.5, -0.2, 0.9))

    table = any_grasp_table(item, talos, "right", 0.0, 0.1, (0.12,), 0.0)

    assert table.name(0).startswith("yaw")


@pytest.mark.parametrize(
    ("mesh", "said"),
    [
        (foreign.plate(), "flatter than this hand's fingers are thick: 12 mm, and the fingers 24 mm"),
        (foreign.trimesh.creation.icosphere(radius=0.07), "too wide for the hand"),
        (foreign.bowl(), "face each other|thinner than 20 mm"),
    ],
    ids=["plate", "globe", "bowl"],
)
def test_what_a_hand_cannot_take_is_refused_with_the_reason(mesh, said, talos):
    import re

    shape = thing(mesh, said)
    forced = ConvexParts(
        said,
        shape.parts.corners,
        shape.parts.ends,
        shape.parts.surface,
        shape.parts.normals,
        outline_error_m=0.02,
    )
    outline = Box(tuple(np.ptp(forced.corners, axis=0).tolist()), forced)

    reason = no_grasp_reason(SceneObject("thing", outline, np.eye(4)), talos, "right")

    assert reason is not None
    assert re.search(said, reason)


def test_two_slim_fingers_take_a_wide_mug_by_its_wall_or_handle_and_thick_ones_do_not(talos, wide_mug):
    parts = wide_mug.parts
    panda = RobotModel(load_description("panda"))

    slim, thick = (shape_grasps(parts, one, "right", np.eye(4)) for one in (panda, talos))

    assert len(slim.cost) > 10
    assert slim.opening_m.max() < 0.03
    assert holds(parts, slim.object_T_tcp[0], 0.08, (0.009, 0.011))
    assert not len(thick.cost)


def test_what_hardly_any_grasp_is_found_of_is_looked_at_more_densely(talos, wide_mug, monkeypatch):
    densely = shape_grasps(as_wide_as(wide_mug.parts, 0.72, "once"), talos, "left", np.eye(4))
    monkeypatch.setattr(module, "_DENSE", module._USUAL)

    usually = shape_grasps(as_wide_as(wide_mug.parts, 0.72, "twice"), talos, "left", np.eye(4))

    assert 0 < len(usually.cost) < module._ENOUGH
    assert len(densely.cost) > 1.5 * len(usually.cost)


def test_what_many_are_found_of_is_not(talos, wide_mug, monkeypatch):
    monkeypatch.setattr(module, "_DENSE", None)

    found = shape_grasps(as_wide_as(wide_mug.parts, 0.6, "slim"), talos, "left", np.eye(4))

    assert len(found.cost) >= module._ENOUGH


def test_what_is_too_wide_by_its_outline_is_taken_by_its_wall():
    panda = RobotModel(load_description("panda"))
    solid = thing(foreign.bowl(0.05, 0.05, 0.005), "ramekin")
    fits = replace(solid, parts=replace(solid.parts, outline_error_m=0.005))

    table = any_grasp_table(SceneObject("ramekin", fits, np.eye(4)), panda, "right", 0.0, 0.1, (0.12,), 0.0)

    assert len(table)
    assert table.diameter_m.max() < 0.02
