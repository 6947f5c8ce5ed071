"""The messages of a camera, as ``messages`` has the others."""

import struct
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any, TypeAlias

from cyclonedds.idl import IdlStruct
from cyclonedds.idl.annotations import final

from executive.doors.ros.messages import Header

if TYPE_CHECKING:
    float64: TypeAlias = float
    uint8: TypeAlias = int
    uint32: TypeAlias = int
    sequence = Sequence
    Nine: TypeAlias = Sequence[float]
    Twelve: TypeAlias = Sequence[float]
else:
    from cyclonedds.idl.types import array, float64, sequence, uint8, uint32

    Nine, Twelve = array[float64, 9], array[float64, 12]

_LENGTH = struct.Struct("=I")


@dataclass
@final
class Image(IdlStruct, typename="sensor_msgs.msg.dds_.Image_"):
    """A picture: ``step`` bytes a row, as ``encoding`` says, row by row."""

    header: Header = field(default_factory=Header)
    height: uint32 = 0
    width: uint32 = 0
    encoding: str = ""
    is_bigendian: uint8 = 0
    step: uint32 = 0
    data: sequence[uint8] = field(default_factory=list)

    def serialize(self, *options: Any, **named: Any) -> bytes:
        """As every message, but pixels that are bytes already are not taken apart and put together again."""
        if not isinstance(self.data, bytes):
            return super().serialize(*options, **named)
        head = replace(self, data=[]).serialize(*options, **named)
        return b"".join((head[: -_LENGTH.size], _LENGTH.pack(len(self.data)), self.data))


@dataclass
@final
class RegionOfInterest(IdlStruct, typename="sensor_msgs.msg.dds_.RegionOfInterest_"):
    """The part of a picture that is given; nothing but zeros for all of it."""

    x_offset: uint32 = 0
    y_offset: uint32 = 0
    height: uint32 = 0
    width: uint32 = 0
    do_rectify: bool = False


@dataclass
@final
class CameraInfo(IdlStruct, typename="sensor_msgs.msg.dds_.CameraInfo_"):
    """The lens of a camera: distortion, and the matrices K, R and P, row by row."""

    header: Header = field(default_factory=Header)
    height: uint32 = 0
    width: uint32 = 0
    distortion_model: str = ""
    d: sequence[float64] = field(default_factory=list)
    k: Nine = field(default_factory=lambda: [0.0] * 9)
    r: Nine = field(default_factory=lambda: [0.0] * 9)
    p: Twelve = field(default_factory=lambda: [0.0] * 12)
    binning_x: uint32 = 0
    binning_y: uint32 = 0
    roi: RegionOfInterest = field(default_factory=RegionOfInterest)
