import numpy as np
import pytest

from kinematics.requests.move import MoveRequest
from kinematics.scene.planning_scene import PlanningScene
from robots.fake.fake_world import cup


def place(fake, name="red cup"):
    return fake.world.object(name).world_T_object[:3, 3]


def frame_after_a_step(fake):
    fake.step()
    fake.step()
    return {item.kind for item in fake.detector.latest().detections}


def look_down(fake):
    move = MoveRequest(
        fake.motion.reference(),
        fake.motion.stance(),
        PlanningScene(),
        {"head_1_joint": 0.77},
        keep_others=True,
    )
    step = fake.planning.answer(move).step
    handle = fake.motion.start(fake.planning.verdict(step.question))
    while not handle.finished:
        fake.step()


def test_a_push_moves_a_thing(fake):
    before = place(fake).copy()

    fake.world.move("red cup", (0.0, 0.05, 0.0))

    np.testing.assert_allclose(place(fake) - before, (0.0, 0.05, 0.0))


def test_what_falls_beside_the_table_ends_on_the_floor(fake):
    fake.world.move("red cup", (0.0, 1.0, 0.0))

    fake.world.drop("red cup")

    assert place(fake)[2] == pytest.approx(0.055)


def test_what_is_removed_is_gone(fake):
    fake.world.remove("red cup")

    assert [item.name for item in fake.world.solids()] == ["table"]


def test_things_are_told_in_a_fixed_order(fake):
    fake.world.put(cup("a cup"))

    assert [item.name for item in fake.world.solids()] == ["a cup", "red cup", "table"]


def test_the_camera_sees_the_cup_where_it_is(fake):
    look_down(fake)
    fake.step()
    frame = fake.detector.latest()
    (seen,) = [item for item in frame.detections if item.kind == "cup"]

    np.testing.assert_allclose(
        fake.world.world_T_camera() @ seen.camera_T_object,
        fake.world.object("red cup").world_T_object,
        atol=1e-9,
    )


def test_what_is_hidden_out_of_view_or_behind_closed_eyes_is_not_seen(fake):
    look_down(fake)
    assert frame_after_a_step(fake) == {"cup", "table"}
    fake.world.hidden.add("red cup")
    assert frame_after_a_step(fake) == {"table"}
    fake.world.hidden.clear()
    fake.world.move("red cup", (0.0, 0.0, 1.5))
    assert frame_after_a_step(fake) == {"table"}
    fake.detector.blind = True
    assert frame_after_a_step(fake) == set()


def test_a_wrong_detection_is_wrong_by_its_offset(fake):
    look_down(fake)
    fake.detector.offset_m["red cup"] = (0.0, 0.04, 0.0)
    fake.step()
    (seen,) = [item for item in fake.detector.latest().detections if item.kind == "cup"]

    told = (fake.world.world_T_camera() @ seen.camera_T_object)[:3, 3]
    np.testing.assert_allclose(told - place(fake), (0.0, 0.04, 0.0), atol=1e-9)


def test_frames_have_rising_numbers_and_their_own_stamps(fake):
    first = fake.detector.latest()
    fake.step()
    second = fake.detector.latest()

    assert second.sequence == first.sequence + 1
    assert second.stamp_s == pytest.approx(first.stamp_s + 0.02)
