"""Messages of ROS 2 that are recorded and never sent, as ``executive.doors.ros.messages`` has the others."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, TypeAlias

from cyclonedds.idl import IdlStruct
from cyclonedds.idl.annotations import final

from executive.doors.ros.messages import Header, Time

if TYPE_CHECKING:
    float64: TypeAlias = float
    uint8: TypeAlias = int
    uint32: TypeAlias = int
    sequence = Sequence
else:
    from cyclonedds.idl.types import float64, sequence, uint8, uint32

INFO, WARNING = 20, 30


@dataclass
@final
class MultiArrayDimension(IdlStruct, typename="std_msgs.msg.dds_.MultiArrayDimension_"):
    """One dimension of an array of numbers."""

    label: str = ""
    size: uint32 = 0
    stride: uint32 = 0


@dataclass
@final
class MultiArrayLayout(IdlStruct, typename="std_msgs.msg.dds_.MultiArrayLayout_"):
    """What the numbers of an array mean."""

    dim: sequence[MultiArrayDimension] = field(default_factory=list)
    data_offset: uint32 = 0


@dataclass
@final
class Float64MultiArray(IdlStruct, typename="std_msgs.msg.dds_.Float64MultiArray_"):
    """Numbers."""

    layout: MultiArrayLayout = field(default_factory=MultiArrayLayout)
    data: sequence[float64] = field(default_factory=list)


@dataclass
@final
class CompressedImage(IdlStruct, typename="sensor_msgs.msg.dds_.CompressedImage_"):
    """A picture as the file of some format."""

    header: Header = field(default_factory=Header)
    format: str = ""
    data: sequence[uint8] = field(default_factory=list)

    def serialize(self, *options: Any, **named: Any) -> bytes:
        """As every message, but bytes of a file are not taken apart and put together again."""
        if not isinstance(self.data, bytes):
            return super().serialize(*options, **named)
        head = CompressedImage(self.header, self.format, []).serialize(*options, **named)
        return b"".join((head[:-4], len(self.data).to_bytes(4, "little"), self.data))


@dataclass
@final
class Log(IdlStruct, typename="rcl_interfaces.msg.dds_.Log_"):
    """A line of a log: level 20 tells something, 30 warns."""

    stamp: Time = field(default_factory=Time)
    level: uint8 = INFO
    name: str = ""
    msg: str = ""
    file: str = ""
    function: str = ""
    line: uint32 = 0
