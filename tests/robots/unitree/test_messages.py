"""The messages as DDS writes them, field by field, against the bytes that are sent here."""

import numpy as np
import pytest

pytest.importorskip("cyclonedds")

from cyclonedds.idl import IdlStruct

from robots.unitree.layout import (
    HAND_COMMAND,
    HAND_STATE,
    LOW_COMMAND,
    LOW_STATE,
    MOTORS,
    from_wire,
    seal,
)
from robots.unitree.messages import (
    HandCommand,
    HandState,
    ImuState,
    LowCommand,
    LowState,
    MotorCommand,
    MotorState,
    PressState,
    carried,
    carrying,
)


def numbers(seed, count):
    return np.random.default_rng(seed).normal(0.0, 1.0, count).astype(np.float32).tolist()


def a_command():
    motors = [MotorCommand(k % 2, *numbers(k, 5), k) for k in range(MOTORS)]
    return LowCommand(0, 5, motors, [1, 2, 3, 4], 99)


def a_state():
    motors = [MotorState(1, *numbers(k, 4), [k, -k], 48.0, [k, 2], k, [5, 6, 7, 8]) for k in range(MOTORS)]
    imu = ImuState(numbers(1, 4), numbers(2, 3), numbers(3, 3), numbers(4, 3), 41)
    return LowState([1, 2], 0, 5, 77, imu, motors, list(range(40)), [9, 8, 7, 6], 123)


def a_hand_command():
    return HandCommand([MotorCommand(0x90 + k, *numbers(k, 5), k) for k in range(7)], [1, 2, 3, 4])


def a_hand_state(pressures):
    motors = [MotorState(1, *numbers(k, 4), [k, -k], 48.0, [k, 2], k, [5, 6, 7, k]) for k in range(7)]
    imu = ImuState(numbers(1, 4), numbers(2, 3), numbers(3, 3), numbers(4, 3), 41)
    return HandState(
        motors, [PressState() for _ in range(pressures)], imu, 24.0, 1.0, 0.0, 0.0, [1, 2], [3, 4]
    )


def written(message):
    """As cyclonedds itself has it, behind the head."""
    return IdlStruct.serialize(message, use_version_2=False)


def test_a_command_that_dds_wrote_is_read_field_by_field():
    message = a_command()

    record = from_wire(written(message)[4:], LOW_COMMAND)

    assert record["motor"]["q"].tolist() == [motor.q for motor in message.motor_cmd]
    assert record["motor"]["mode"].tolist() == [motor.mode for motor in message.motor_cmd]
    assert record["reserve"].tolist() == message.reserve
    assert int(record["crc"]) == 99


def test_a_state_that_dds_wrote_is_read_field_by_field():
    message = a_state()

    record = from_wire(written(message)[4:], LOW_STATE)

    assert record["imu"]["rpy"].tolist() == message.imu_state.rpy
    assert record["motor"]["temperature"].tolist() == [motor.temperature for motor in message.motor_state]
    assert record["motor"]["motorstate"].tolist() == list(range(MOTORS))
    assert record["wireless_remote"].tolist() == list(range(40))
    assert int(record["tick"]) == 77


@pytest.mark.parametrize(("message", "kind"), [(a_command(), LOW_COMMAND), (a_state(), LOW_STATE)])
def test_what_is_sent_is_to_the_byte_what_dds_would_have_written(message, kind):
    record = from_wire(written(message)[4:], kind)

    assert carrying(type(message), record).serialize() == written(message)


@pytest.mark.parametrize("pressures", [0, 9])
def test_a_hands_state_is_read_whatever_pressures_it_tells(pressures):
    message = a_hand_state(pressures)

    record = from_wire(written(message)[4:], HAND_STATE)

    assert record["motor"]["q"].tolist() == [motor.q for motor in message.motor_state]
    assert record["motor"]["reserve"].tolist() == [motor.reserve for motor in message.motor_state]


def test_a_hands_command_is_to_the_byte_what_dds_would_have_written():
    message = a_hand_command()

    record = from_wire(written(message)[4:], HAND_COMMAND)

    assert record["motor"]["kd"].tolist() == [motor.kd for motor in message.motor_cmd]
    assert carrying(HandCommand, record).serialize() == written(message)


def test_the_state_of_a_hand_that_is_played_can_be_read_by_dds():
    record = from_wire(written(a_hand_state(0))[4:], HAND_STATE)

    read = IdlStruct.deserialize.__func__(HandState, carrying(HandState, record).serialize())

    assert [motor.q for motor in read.motor_state] == record["motor"]["q"].tolist()
    assert read.press_sensor_state == []


@pytest.mark.parametrize("motors", [0, 6, 8])
def test_a_hand_with_another_number_of_motors_is_none(motors):
    message = HandCommand([MotorCommand() for _ in range(motors)])

    assert from_wire(written(message)[4:], HAND_COMMAND) is None


def test_what_is_no_such_message_carries_nothing():
    assert carried(LowState.deserialize(b"\x00\x01\x00\x00" + b"short")) is None
    assert carried(LowState.deserialize(b"\x00\x00\x00\x00" + bytes(2088))) is None  # big-endian
    assert carried(LowState.deserialize(b"")) is None


def test_a_message_comes_back_as_it_was_sent():
    record = from_wire(written(a_state())[4:], LOW_STATE)
    seal(record)

    assert carried(LowState.deserialize(carrying(LowState, record).serialize())) == record
