"""Counting and describing rest on looks that leave nothing out."""

import itertools

import numpy as np

from trees.beliefs.sight.sight import in_view
from trees.skills.telling.settings import TellingSettings

TOPS_M = (0.75, 0.82, 0.9, 1.0)
AHEAD_M, ASIDE_M = np.arange(0.36, 0.62, 0.04), np.arange(-0.48, 0.49, 0.04)
MISSED_SHARE = 0.01


def camera_at(model, gaze):
    """Pose of the camera with head and trunk at a gaze and everything else at home."""
    camera = model.description.camera
    q = model.q_home.copy()
    for joint, angle in (
        (camera.lean_joint, gaze.lean_rad),
        (camera.pan_joint, gaze.pan_rad),
        (camera.tilt_joint, gaze.tilt_rad),
        ("torso_1_joint", gaze.turn_rad),
    ):
        q[7 + model.joint_index(joint)] = angle
    return model.frame_pose(q, camera.frame)


def test_the_looks_of_an_inventory_show_all_of_a_near_table_whatever_its_height(model):
    cameras = [camera_at(model, gaze) for gaze in TellingSettings().inventory_gazes]
    places = [np.array([x, y, z + 0.05]) for z, x, y in itertools.product(TOPS_M, AHEAD_M, ASIDE_M)]

    missed = [
        place
        for place in places
        if not any(in_view(model.description.camera, pose, place) for pose in cameras)
    ]

    assert len(missed) <= MISSED_SHARE * len(places)
