"""The slot holds the newest picture, whole or not at all, and only while somebody wants it."""

import os
import stat

import numpy as np
import pytest

from kinematics.whole_file import write_whole
from robots.interface.depth_camera import DepthCamera
from robots.perception.rgbd.picture import Picture
from robots.perception.rgbd.picture_slot import PictureSlotReader, PictureSlotWriter

CAMERA = DepthCamera("head", "optical", 20.0, width_px=16, height_px=12)


@pytest.fixture
def path(tmp_path):
    return tmp_path / "picture"


@pytest.fixture
def slot(path):
    """A writer, and a reader that wants its pictures."""
    writer, reader = PictureSlotWriter(path), PictureSlotReader(path)
    reader.want(True)
    yield writer, reader
    reader.want(False)


def picture(seed=1, stamp_s=0.5):
    rng = np.random.default_rng(seed)
    color = rng.integers(0, 256, (12, 16, 3), dtype=np.uint8)
    depth = rng.uniform(0.3, 8.0, (12, 16)).astype(np.float32)
    depth[3, 4] = 0.0
    return Picture(CAMERA, color, depth, np.zeros((12, 16), bool), np.eye(4), stamp_s)


def test_the_newest_picture_comes_back_once(slot):
    writer, reader = slot
    for seed in (1, 2, 3):
        writer.show(picture(seed, 0.5 * seed))
    shown = reader.newest()

    assert (shown.frame, shown.focal_px, shown.stamp_s) == ("optical", 20.0, 1.5)
    np.testing.assert_array_equal(shown.color, picture(3).color)
    np.testing.assert_array_equal(shown.depth_mm, np.rint(1000.0 * picture(3).depth_m))
    assert shown.depth_mm[3, 4] == 0
    assert reader.newest() is None


def test_a_depth_that_is_too_far_for_its_number_is_the_farthest_and_not_a_near_one(slot):
    writer, reader = slot
    far = picture()
    far.depth_m[0, 0] = 70.0

    writer.show(far)

    assert reader.newest().depth_mm[0, 0] == 65535


def test_nothing_is_written_that_nobody_wants(path):
    writer, reader = PictureSlotWriter(path), PictureSlotReader(path)
    writer.show(picture())
    reader.want(True)
    reader.want(False)
    writer.show(picture())

    assert not path.exists()
    assert reader.newest() is None


def test_pictures_are_written_until_the_last_one_who_wants_them_does_not(slot, path):
    writer, reader = slot
    other = PictureSlotReader(path)
    other.want(True)
    other.want(False)
    writer.show(picture())

    assert reader.newest() is not None


def test_a_process_that_ends_wants_nothing_any_more(path):
    writer = PictureSlotWriter(path)
    child = os.fork()
    if child == 0:
        PictureSlotReader(path).want(True)
        os._exit(0)
    os.waitpid(child, 0)

    writer.show(picture())

    assert not path.exists()


@pytest.mark.parametrize("size", [0, 5, 100, 900, -1])
def test_a_torn_file_is_no_picture(slot, path, size):
    writer, reader = slot
    writer.show(picture())
    path.write_bytes(path.read_bytes()[:size])

    assert reader.newest() is None


@pytest.mark.parametrize(
    "content",
    [
        b"", b"\n", b"{}\n", b"[1]\n", b'{"frame": "optical"}\n',
        b'{"frame": "a", "focal_px": 1, "width_px": 2, "height_px": 2, "stamp_s": 0}\n' + bytes(19),
        b'{"frame": "a", "focal_px": 1, "width_px": -2, "height_px": -2, "stamp_s": 0}\n' + bytes(20),
    ],
)  # fmt: skip
def test_a_whole_file_of_something_else_is_no_picture(path, content):
    write_whole(path, content)

    assert PictureSlotReader(path).newest() is None


def test_it_is_the_owners_alone_and_goes_with_its_writer(slot, path):
    writer, _ = slot
    writer.show(picture())
    assert stat.S_IMODE(path.stat().st_mode) == 0o600

    writer.close()

    assert not path.exists()


def test_a_picture_that_was_left_by_another_writer_is_taken_away(slot, path):
    writer, reader = slot
    writer.show(picture())
    PictureSlotWriter(path)

    assert reader.newest() is None


def test_a_slot_that_cannot_be_written_costs_a_picture_and_nothing_else(slot, path):
    writer, reader = slot
    path.mkdir()

    writer.show(picture())

    assert reader.newest() is None
