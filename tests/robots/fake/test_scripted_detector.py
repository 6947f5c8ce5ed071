"""A picture shows the world as it was when it was taken."""

import numpy as np


def tables_in(fake):
    return [item for item in fake.detector.latest().detections if item.kind == "table"]


def test_what_moves_after_a_picture_was_taken_is_where_it_was(fake):
    (seen,) = tables_in(fake)
    fake.step()
    fake.world.move("table", (0.1, 0.0, 0.0))
    (late,) = tables_in(fake)
    np.testing.assert_array_equal(seen.camera_T_object, late.camera_T_object)

    fake.step()

    (moved,) = tables_in(fake)
    assert not np.array_equal(seen.camera_T_object, moved.camera_T_object)


def test_what_is_hidden_after_a_picture_was_taken_is_in_it(fake):
    before = len(tables_in(fake))
    fake.step()
    fake.world.hidden.add("table")
    in_the_picture = len(tables_in(fake))
    fake.step()

    assert (before, in_the_picture, len(tables_in(fake))) == (1, 1, 0)


def test_what_is_misplaced_after_a_picture_was_taken_is_where_it_was(fake):
    (seen,) = tables_in(fake)
    fake.step()
    fake.detector.offset_m["table"] = (0.0, 0.0, -0.2)
    (late,) = tables_in(fake)
    np.testing.assert_array_equal(seen.camera_T_object, late.camera_T_object)

    fake.step()

    (misplaced,) = tables_in(fake)
    assert not np.array_equal(seen.camera_T_object, misplaced.camera_T_object)


def test_a_camera_that_is_frozen_keeps_its_picture(fake):
    before = fake.detector.latest()
    fake.detector.frozen = True
    fake.step()

    assert fake.detector.latest() is before


def test_a_camera_that_is_blind_takes_pictures_that_show_nothing(fake):
    before = fake.detector.latest()
    fake.detector.blind = True
    fake.step()

    assert fake.detector.latest().sequence == before.sequence + 1
    assert fake.detector.latest().detections == ()
