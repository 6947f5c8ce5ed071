"""The slot holds what is newest, whole, however slowly anybody reads."""

import dataclasses
import stat

import numpy as np
import pytest

from robots.live.documents.robot_report import ReportLayout, RobotReport
from robots.live.wire.errors import ProtocolError
from robots.live.wire.state_slot import StateSlotReader, StateSlotWriter


@pytest.fixture
def path(tmp_path):
    return tmp_path / "state"


def test_a_reader_gets_the_newest_values_once(path):
    writer = StateSlotWriter(path, 3)
    reader = StateSlotReader(path)
    assert reader.newest() is None

    for value in (1.0, 2.0, 3.0):
        writer.write(np.full(3, value))

    np.testing.assert_array_equal(reader.newest(), [3.0, 3.0, 3.0])
    assert reader.newest() is None


@pytest.mark.requirement("F4")
def test_values_that_are_being_written_are_not_taken(path):
    writer = StateSlotWriter(path, 2)
    writer.write(np.ones(2))
    reader = StateSlotReader(path)
    reader.newest()

    writer._memory[8] = 3  # odd: the writer is at it, and stays there
    writer._memory[24:32] = b"\0" * 8

    assert reader.newest() is None


def test_it_is_the_owners_alone_and_goes_with_its_writer(path):
    writer = StateSlotWriter(path, 2)
    assert stat.S_IMODE(path.stat().st_mode) == 0o600

    writer.close()

    assert not path.exists()


@pytest.mark.parametrize("content", [b"", b"short", b"HXSTATE9" + b"\0" * 40, b"HXSTATE1" + b"\xff" * 40])
def test_what_is_no_slot_is_refused(path, content):
    path.write_bytes(content)

    with pytest.raises(ProtocolError):
        StateSlotReader(path)


def test_a_report_comes_back_bit_by_bit(live, talos):
    live.run(0.1)
    layout = ReportLayout(talos)
    loop = live.loop
    sent = RobotReport(
        live.clock.now_s(),
        loop.motion.resting,
        True,
        loop.sensing.state(),
        loop.motion.reference(),
        loop.motion.stance(),
        {hand: gripper.reading() for hand, gripper in loop.grippers.items()},
    )

    read = layout.report(layout.row(sent))

    assert read.walking
    assert not read.ending
    assert layout.report(layout.row(dataclasses.replace(sent, ending=True))).ending
    assert read.landings.shape == (0, 4)
    ahead = np.array([[1.0, 0.2, 0.1, 0.0], [-1.0, 0.4, -0.1, 0.05]])
    told = layout.report(layout.row(dataclasses.replace(sent, landings=ahead)))
    np.testing.assert_array_equal(told.landings, ahead)
    assert (read.t_s, read.resting, read.grippers) == (sent.t_s, sent.resting, sent.grippers)
    np.testing.assert_array_equal(read.sensed.q, sent.sensed.q)
    np.testing.assert_array_equal(read.reference, sent.reference)
    assert read.stance.key == sent.stance.key
    for name in ("q", "v", "effort", "gyro", "accelerometer", "foot_wrench"):
        np.testing.assert_array_equal(
            getattr(read.sensed.readings, name), getattr(sent.sensed.readings, name)
        )
