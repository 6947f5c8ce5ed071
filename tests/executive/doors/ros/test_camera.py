"""Pictures on their topics: what is in the messages, their stamps, and that nobody draws for nobody."""

import numpy as np
import pytest

from executive.doors.ros.camera import CameraTopics, StateStamps, camera_info, color_image, depth_image
from executive.doors.ros.camera_messages import CameraInfo, Image
from executive.doors.ros.graph import RosNode, best_effort, taken
from executive.doors.ros.messages import Time
from executive.doors.ros.settings import RosSettings
from robots.clock import WallClock
from robots.interface.depth_camera import DepthCamera
from robots.perception.rgbd.picture import Picture
from robots.perception.rgbd.picture_slot import PictureSlotWriter, ShownPicture

pytestmark = pytest.mark.requirement("U3")
DOMAIN = 44
CAMERA = DepthCamera("head", "optical", 20.0, width_px=16, height_px=12)
STAMP = Time(1_700_000_000, 5)


@pytest.fixture
def shown():
    rng = np.random.default_rng(2)
    color = rng.integers(0, 256, (12, 16, 3), dtype=np.uint8)
    return ShownPicture("optical", 20.0, 1.5, color, rng.integers(0, 65536, (12, 16), dtype=np.uint16))


def test_colours_are_rows_of_red_green_and_blue(shown):
    image = color_image(shown, STAMP)

    assert (image.height, image.width, image.encoding, image.step) == (12, 16, "rgb8", 48)
    assert (image.header.frame_id, image.header.stamp) == ("optical", STAMP)
    assert list(image.data[48:51]) == shown.color[1, 0].tolist()
    assert len(image.data) == 12 * 48


def test_depths_are_millimetres_with_the_low_byte_first(shown):
    image = depth_image(shown, STAMP)

    assert (image.height, image.width, image.encoding, image.step) == (12, 16, "16UC1", 32)
    assert image.is_bigendian == 0
    assert int.from_bytes(image.data[34:36], "little") == shown.depth_mm[1, 1]


def test_the_lens_projects_a_point_to_the_pixel_that_shows_it(shown):
    info = camera_info(shown, STAMP)
    picture = Picture(CAMERA, shown.color, shown.depth_mm.astype(np.float32), None, np.eye(4), 1.5)
    points = np.random.default_rng(3).uniform((-1.0, -1.0, 0.5), (1.0, 1.0, 4.0), (50, 3))

    for matrix in (np.reshape(info.k, (3, 3)), np.reshape(info.p, (3, 4))[:, :3]):
        projected = points @ matrix.T
        np.testing.assert_allclose(projected[:, :2] / projected[:, 2:], picture.pixels_of(points))
    assert (info.height, info.width, info.distortion_model, info.d) == (12, 16, "plumb_bob", [0.0] * 5)


def test_a_picture_between_two_states_is_stamped_between_them():
    stamps = StateStamps()
    stamps.note(1.0, Time(100, 990_000_000))
    stamps.note(1.01, Time(101, 10_000_000))

    assert stamps.at(1.0) == Time(100, 990_000_000)
    assert stamps.at(1.005) == Time(101, 0)
    assert stamps.at(1.02) == Time(101, 10_000_000)


@pytest.mark.parametrize("t_s", [0.5, 9.0])
def test_an_instant_of_which_no_state_is_known_has_no_stamp(t_s):
    stamps = StateStamps()
    assert stamps.at(t_s) is None

    for state_s in (1.0, 1.01):
        stamps.note(state_s, STAMP)

    assert stamps.at(t_s) is None


def test_states_of_a_control_process_that_has_ended_stamp_nothing_of_the_next_one():
    stamps = StateStamps()
    stamps.note(50.0, STAMP)
    stamps.note(0.1, STAMP)

    assert stamps.at(50.0) is None


def test_pictures_are_wanted_while_a_topic_is_heard_and_come_with_their_lens(tmp_path):
    stamps, wall = StateStamps(), WallClock()
    stamps.note(0.0, STAMP)
    node, slot = RosNode(RosSettings(DOMAIN)), PictureSlotWriter(tmp_path / "picture")
    topics = CameraTopics(node, tmp_path / "picture", stamps)
    color = np.full((12, 16, 3), 7, np.uint8)
    picture = Picture(CAMERA, color, np.ones((12, 16), np.float32), None, np.eye(4), 0.0)
    topics.poll()
    slot.show(picture)
    assert not (tmp_path / "picture").exists()

    wanted = (("/camera/depth/image_raw", Image), ("/camera/depth/camera_info", CameraInfo))
    readers = [node.reader(topic, kind, best_effort(1)) for topic, kind in wanted]
    came, until_s = [[], []], wall.now_s() + 30.0
    while not all(came):
        assert wall.now_s() < until_s
        slot.show(picture)
        topics.poll()
        for messages, reader in zip(came, readers, strict=True):
            messages += taken(reader)
        wall.sleep(0.02)

    image, info = came[0][0], came[1][0]
    assert image.header == info.header
    assert bytes(image.data[:2]) == (1000).to_bytes(2, "little")


def test_topics_that_are_closed_want_nothing_any_more(tmp_path):
    slot, wall = tmp_path / "picture", WallClock()
    node, writer = RosNode(RosSettings(DOMAIN)), PictureSlotWriter(slot)
    topics = CameraTopics(node, slot, StateStamps())
    reader = node.reader("/camera/color/camera_info", CameraInfo, best_effort(1))
    picture = Picture(
        CAMERA, np.zeros((12, 16, 3), np.uint8), np.ones((12, 16), np.float32), None, np.eye(4), 0.0
    )
    topics.begin(wall)
    until_s = wall.now_s() + 30.0
    while not slot.exists():
        assert wall.now_s() < until_s
        writer.show(picture)
        wall.sleep(0.02)

    topics.close()
    slot.unlink()
    writer.show(picture)

    assert not slot.exists()
    assert not taken(reader)
