"""The low-level messages as DDS types, field by field those of ``unitree_hg``; their bytes are ``layout``'s.

The annotations are read by cyclonedds when a class is made, so that they are no strings.
"""

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, TypeAlias, TypeVar

from cyclonedds.idl import IdlStruct
from cyclonedds.idl.annotations import final

from robots.unitree.layout import (
    HAND_COMMAND,
    HAND_STATE,
    LOW_COMMAND,
    LOW_STATE,
    MOTORS,
    Record,
    from_wire,
    to_wire,
)

if TYPE_CHECKING:
    float32: TypeAlias = float
    int16: TypeAlias = int
    uint8: TypeAlias = int
    uint32: TypeAlias = int
    Floats3: TypeAlias = list[float]
    Floats4: TypeAlias = list[float]
    Pair: TypeAlias = list[int]
    Words2: TypeAlias = list[int]
    Words4: TypeAlias = list[int]
    Bytes40: TypeAlias = list[int]
    Floats12: TypeAlias = list[float]
else:
    from cyclonedds.idl.types import array, float32, int16, sequence, uint8, uint32

    Floats3, Floats4, Pair = array[float32, 3], array[float32, 4], array[int16, 2]
    Floats12 = array[float32, 12]
    Words2, Words4, Bytes40 = array[uint32, 2], array[uint32, 4], array[uint8, 40]

M = TypeVar("M", bound=IdlStruct)
_HEAD = bytes((0, 1, 0, 0))
"""Of little-endian CDR."""
_LITTLE_ENDIAN = 1


def carrying(kind: type[M], record: Record) -> M:
    """The message of a record, which stays bytes: 35 motors put together field by field take 1 to 3 ms."""
    made = object.__new__(kind)
    made.__dict__["record"] = record
    return made


def carried(message: Any) -> Record | None:
    """The record of a message that came; None of what was none."""
    found: Record | None = getattr(message, "__dict__", {}).get("record")
    return found


def _in_bytes(kind: type[M]) -> type[M]:
    """A kind of message that goes over the wire as its record's bytes; one without is put together by field.

    No base class: cyclonedds takes each base of a message for a message, when it tells its peers of the type.
    """
    by_field = kind.serialize

    def serialize(message: M, *options: Any, **named: Any) -> bytes:
        record = carried(message)
        if record is not None:
            return _HEAD + to_wire(record)
        fields: bytes = by_field(message, *options, **named)
        return fields

    def deserialize(data: bytes, *_options: Any, **_named: Any) -> M:
        little = len(data) > len(_HEAD) and data[1] & _LITTLE_ENDIAN
        made = object.__new__(kind)
        made.__dict__["record"] = from_wire(bytes(data[len(_HEAD) :]), KINDS[kind]) if little else None
        return made

    replaced: Any = kind
    replaced.serialize, replaced.deserialize = serialize, staticmethod(deserialize)
    return kind


@dataclass
@final
class MotorCommand(IdlStruct, typename="unitree_hg.msg.dds_.MotorCmd_"):
    """What one motor is to do."""

    mode: uint8 = 0
    q: float32 = 0.0
    dq: float32 = 0.0
    tau: float32 = 0.0
    kp: float32 = 0.0
    kd: float32 = 0.0
    reserve: uint32 = 0


@dataclass
@final
class MotorState(IdlStruct, typename="unitree_hg.msg.dds_.MotorState_"):
    """What one motor senses."""

    mode: uint8 = 0
    q: float32 = 0.0
    dq: float32 = 0.0
    ddq: float32 = 0.0
    tau_est: float32 = 0.0
    temperature: Pair = field(default_factory=lambda: [0] * 2)
    vol: float32 = 0.0
    sensor: Words2 = field(default_factory=lambda: [0] * 2)
    motorstate: uint32 = 0
    reserve: Words4 = field(default_factory=lambda: [0] * 4)


@dataclass
@final
class ImuState(IdlStruct, typename="unitree_hg.msg.dds_.IMUState_"):
    """What the IMU senses."""

    quaternion: Floats4 = field(default_factory=lambda: [0.0] * 4)
    gyroscope: Floats3 = field(default_factory=lambda: [0.0] * 3)
    accelerometer: Floats3 = field(default_factory=lambda: [0.0] * 3)
    rpy: Floats3 = field(default_factory=lambda: [0.0] * 3)
    temperature: int16 = 0


if TYPE_CHECKING:
    MotorCommands: TypeAlias = list[MotorCommand]
    MotorStates: TypeAlias = list[MotorState]
else:
    MotorCommands, MotorStates = array[MotorCommand, MOTORS], array[MotorState, MOTORS]


@_in_bytes
@dataclass
@final
class LowCommand(IdlStruct, typename="unitree_hg.msg.dds_.LowCmd_"):
    """What all motors are to do."""

    mode_pr: uint8 = 0
    mode_machine: uint8 = 0
    motor_cmd: MotorCommands = field(default_factory=lambda: [MotorCommand() for _ in range(MOTORS)])
    reserve: Words4 = field(default_factory=lambda: [0] * 4)
    crc: uint32 = 0


@_in_bytes
@dataclass
@final
class LowState(IdlStruct, typename="unitree_hg.msg.dds_.LowState_"):
    """What motors and IMU sense."""

    version: Words2 = field(default_factory=lambda: [0] * 2)
    mode_pr: uint8 = 0
    mode_machine: uint8 = 0
    tick: uint32 = 0
    imu_state: ImuState = field(default_factory=ImuState)
    motor_state: MotorStates = field(default_factory=lambda: [MotorState() for _ in range(MOTORS)])
    wireless_remote: Bytes40 = field(default_factory=lambda: [0] * 40)
    reserve: Words4 = field(default_factory=lambda: [0] * 4)
    crc: uint32 = 0


@dataclass
@final
class PressState(IdlStruct, typename="unitree_hg.msg.dds_.PressSensorState_"):
    """What one field of pressure sensors of a hand feels."""

    pressure: Floats12 = field(default_factory=lambda: [0.0] * 12)
    temperature: Floats12 = field(default_factory=lambda: [0.0] * 12)
    lost: uint32 = 0
    reserve: uint32 = 0


if TYPE_CHECKING:
    HandMotorCommands: TypeAlias = list[MotorCommand]
    HandMotorStates: TypeAlias = list[MotorState]
    PressStates: TypeAlias = list[PressState]
else:
    HandMotorCommands, HandMotorStates = sequence[MotorCommand], sequence[MotorState]
    PressStates = sequence[PressState]


@_in_bytes
@dataclass
@final
class HandCommand(IdlStruct, typename="unitree_hg.msg.dds_.HandCmd_"):
    """What the motors of a hand are to do."""

    motor_cmd: HandMotorCommands = field(default_factory=list)
    reserve: Words4 = field(default_factory=lambda: [0] * 4)


@_in_bytes
@dataclass
@final
class HandState(IdlStruct, typename="unitree_hg.msg.dds_.HandState_"):
    """What a hand senses."""

    motor_state: HandMotorStates = field(default_factory=list)
    press_sensor_state: PressStates = field(default_factory=list)
    imu_state: ImuState = field(default_factory=ImuState)
    power_v: float32 = 0.0
    power_a: float32 = 0.0
    system_v: float32 = 0.0
    device_v: float32 = 0.0
    error: Words2 = field(default_factory=lambda: [0] * 2)
    reserve: Words2 = field(default_factory=lambda: [0] * 2)


KINDS: dict[type[IdlStruct], Any] = {
    LowCommand: LOW_COMMAND,
    LowState: LOW_STATE,
    HandCommand: HAND_COMMAND,
    HandState: HAND_STATE,
}
"""How the bytes of each are read."""
