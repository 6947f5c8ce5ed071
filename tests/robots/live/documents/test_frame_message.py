"""A frame of perception crosses the socket whole."""

from dataclasses import MISSING, fields, replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball, Box, Cylinder
from kinematics.scene.known_part import KnownPart
from robots.live.documents.frame_message import read_frame, write_frame
from robots.live.wire.messages import read_object
from robots.perception.detector import Detection, PerceptionFrame
from robots.perception.position_error import PositionError
from robots.scenes.meshes.object_model import ObjectModel, read_model, write_model
from tests.kinematics.parts_of_things import CORNERS, of_hulls, outlined

POSE = poses.transform(poses.rotation_z(0.3), (0.1, -0.2, 1.5))
ERROR = PositionError(np.diag([1e-5, 2e-5, 3e-5]), 1e-6 * np.eye(3), 0.02, np.diag([4e-6, 5e-6, 6e-6]))
SHUT = poses.transform(poses.rotation_z(-0.2), (0.3, 0.1, 1.1))
DOOR = KnownPart(SHUT, 1.4, "microwave", "door", -1.0, (0.01, -0.25), ("oven", "cooker"))
DRAWER = KnownPart(SHUT, 0.3, "wooden cabinet", "top drawer")
SEEN = (
    Detection("object", "cup", "red", POSE, Cylinder(0.03, 0.1), 0.9),
    Detection("object", "ball", None, POSE, Ball(0.03), 0.8),
    Detection("furniture", "table", None, POSE, Box((0.6, 1.2, 0.04)), 0.95, "side table"),
    Detection("person", "person", None, POSE, Cylinder(0.25, 1.7), 0.7, "Ana"),
    Detection("object", "can", "blue", POSE, Cylinder(0.03, 0.1), 0.9, error=ERROR),
    Detection("object", "bowl", None, POSE, Cylinder(0.03, 0.1), 0.3, picture=bytes(range(256))),
    Detection("object", "tin", None, POSE, Cylinder(0.03, 0.1), 0.6, alike=("can", "cup"), cut=True),
    Detection("person", "person", None, POSE, Cylinder(0.25, 1.7), 0.7, traits=("sitting", "red shirt")),
    Detection("furniture", "table", None, POSE, Box((0.6, 1.2, 0.04)), 0.95, names=("sideboard",)),
    Detection("object", "can", None, POSE, Cylinder(0.03, 0.1), 0.9, names=("soup",), categories=("food",)),
    Detection("furniture", "door", None, POSE, Box((0.02, 0.3, 0.2)), 0.9, moves=DOOR),
    Detection("furniture", "drawer", None, POSE, Box((0.02, 0.3, 0.2)), 0.9, moves=DRAWER),
)


def test_there_is_an_example_of_everything_that_is_told():
    usual = {field.name: field.default for field in fields(Detection) if field.default is not MISSING}

    assert {
        name for name, value in usual.items() if all(getattr(one, name) == value for one in SEEN)
    } == set()


def told(detection: Detection) -> dict[str, Any]:
    return {field.name: getattr(detection, field.name) for field in fields(detection)}


@pytest.mark.parametrize("detection", SEEN, ids=lambda one: one.kind)
def test_everything_that_was_seen_arrives(detection: Detection) -> None:
    frame = PerceptionFrame(1.25, 7, (detection,), tilt_rad=0.01)
    arrived = read_frame(read_object(write_frame(frame)))
    assert (arrived.stamp_s, arrived.sequence, arrived.tilt_rad) == (1.25, 7, 0.01)
    before, after = told(detection), told(arrived.detections[0])
    np.testing.assert_array_equal(before.pop("camera_T_object"), after.pop("camera_T_object"))
    sent, came = before.pop("error"), after.pop("error")
    part, moved = before.pop("moves"), after.pop("moves")
    assert after == before
    assert (part is None) is (moved is None)
    if part is not None:
        np.testing.assert_array_equal(moved.shut, part.shut)
        assert replace(moved, shut=part.shut) == part
    assert (sent is None) is (came is None)
    if sent is not None:
        np.testing.assert_array_equal(came.lasting_m2, sent.lasting_m2)
        np.testing.assert_array_equal(came.noise_m2, sent.noise_m2)
        np.testing.assert_array_equal(came.shared_m2, sent.shared_m2)
        assert came.size_share == sent.size_share


@pytest.fixture
def model(tmp_path: Path) -> ObjectModel:
    outline = outlined(of_hulls("post", [CORNERS * 0.1, CORNERS * 0.1 + 0.05]))
    write_model(ObjectModel(outline, CORNERS, np.array([[0, 1, 2]], np.int32)), tmp_path / "post.model")
    return read_model(tmp_path / "post.model")


@pytest.mark.parametrize("factor", [1.0, 1.7])
def test_what_was_recognised_arrives_with_its_parts(model: ObjectModel, factor: float) -> None:
    shape = model.scaled(factor).outline
    frame = PerceptionFrame(0.0, 1, (Detection("object", "post", None, POSE, shape, 0.9),))

    arrived = read_frame(read_object(write_frame(frame))).detections[0].shape

    assert arrived == shape
    assert arrived.parts is not None
    np.testing.assert_allclose(arrived.parts.corners, factor * model.parts.corners, rtol=1e-9)


def test_where_the_parts_cannot_be_read_the_outline_arrives(model: ObjectModel) -> None:
    frame = PerceptionFrame(0.0, 1, (Detection("object", "post", None, POSE, model.outline, 0.9),))
    sent = write_frame(frame)
    Path(model.parts.file).unlink()

    arrived = read_frame(read_object(sent)).detections[0].shape

    assert arrived.parts is None
    assert arrived.height_m == model.outline.height_m
