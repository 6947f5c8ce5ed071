"""The messages of ROS 2 that cross the wire, as DDS types, and the hash of each that ROS tells them by.

Field by field as in the packages std_msgs, geometry_msgs, sensor_msgs, nav_msgs, tf2_msgs, diagnostic_msgs,
vision_msgs and rmw_dds_common; frames and units are those of REP 103 and REP 105. The annotations are read by
cyclonedds when a class is made, so that they are no strings.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, TypeAlias

from cyclonedds.idl import IdlStruct
from cyclonedds.idl.annotations import final

if TYPE_CHECKING:  # what they are in Python; the DDS's own types say how they are written
    float64: TypeAlias = float
    int32: TypeAlias = int
    uint8: TypeAlias = int
    uint32: TypeAlias = int
    sequence = Sequence
    Nine: TypeAlias = Sequence[float]
    ThirtySix: TypeAlias = Sequence[float]
    Sixteen: TypeAlias = Sequence[int]
else:
    from cyclonedds.idl.types import array, float64, int32, sequence, uint8, uint32

    Nine, ThirtySix, Sixteen = array[float64, 9], array[float64, 36], array[uint8, 16]


@dataclass
@final
class Time(IdlStruct, typename="builtin_interfaces.msg.dds_.Time_"):
    """An instant: seconds and nanoseconds."""

    sec: int32 = 0
    nanosec: uint32 = 0


@dataclass
@final
class Header(IdlStruct, typename="std_msgs.msg.dds_.Header_"):
    """When something was so, and in which frame."""

    stamp: Time = field(default_factory=Time)
    frame_id: str = ""


@dataclass
@final
class String(IdlStruct, typename="std_msgs.msg.dds_.String_"):
    """A text."""

    data: str = ""


@dataclass
@final
class Bool(IdlStruct, typename="std_msgs.msg.dds_.Bool_"):
    """Yes or no."""

    data: bool = False


@dataclass
@final
class Vector3(IdlStruct, typename="geometry_msgs.msg.dds_.Vector3_"):
    """Three numbers."""

    x: float64 = 0.0
    y: float64 = 0.0
    z: float64 = 0.0


@dataclass
@final
class Point(IdlStruct, typename="geometry_msgs.msg.dds_.Point_"):
    """A place."""

    x: float64 = 0.0
    y: float64 = 0.0
    z: float64 = 0.0


@dataclass
@final
class Quaternion(IdlStruct, typename="geometry_msgs.msg.dds_.Quaternion_"):
    """A rotation."""

    x: float64 = 0.0
    y: float64 = 0.0
    z: float64 = 0.0
    w: float64 = 1.0


@dataclass
@final
class Pose(IdlStruct, typename="geometry_msgs.msg.dds_.Pose_"):
    """A place and a rotation."""

    position: Point = field(default_factory=Point)
    orientation: Quaternion = field(default_factory=Quaternion)


@dataclass
@final
class PoseWithCovariance(IdlStruct, typename="geometry_msgs.msg.dds_.PoseWithCovariance_"):
    """A pose, and how sure it is."""

    pose: Pose = field(default_factory=Pose)
    covariance: ThirtySix = field(default_factory=lambda: [0.0] * 36)


@dataclass
@final
class Twist(IdlStruct, typename="geometry_msgs.msg.dds_.Twist_"):
    """A velocity."""

    linear: Vector3 = field(default_factory=Vector3)
    angular: Vector3 = field(default_factory=Vector3)


@dataclass
@final
class TwistStamped(IdlStruct, typename="geometry_msgs.msg.dds_.TwistStamped_"):
    """A velocity, and when it was asked for."""

    header: Header = field(default_factory=Header)
    twist: Twist = field(default_factory=Twist)


@dataclass
@final
class TwistWithCovariance(IdlStruct, typename="geometry_msgs.msg.dds_.TwistWithCovariance_"):
    """A velocity, and how sure it is."""

    twist: Twist = field(default_factory=Twist)
    covariance: ThirtySix = field(default_factory=lambda: [0.0] * 36)


@dataclass
@final
class Transform(IdlStruct, typename="geometry_msgs.msg.dds_.Transform_"):
    """Where one frame is in another."""

    translation: Vector3 = field(default_factory=Vector3)
    rotation: Quaternion = field(default_factory=Quaternion)


@dataclass
@final
class TransformStamped(IdlStruct, typename="geometry_msgs.msg.dds_.TransformStamped_"):
    """A transform between two named frames."""

    header: Header = field(default_factory=Header)
    child_frame_id: str = ""
    transform: Transform = field(default_factory=Transform)


@dataclass
@final
class Wrench(IdlStruct, typename="geometry_msgs.msg.dds_.Wrench_"):
    """A force and a torque."""

    force: Vector3 = field(default_factory=Vector3)
    torque: Vector3 = field(default_factory=Vector3)


@dataclass
@final
class WrenchStamped(IdlStruct, typename="geometry_msgs.msg.dds_.WrenchStamped_"):
    """A wrench in a named frame."""

    header: Header = field(default_factory=Header)
    wrench: Wrench = field(default_factory=Wrench)


@dataclass
@final
class JointState(IdlStruct, typename="sensor_msgs.msg.dds_.JointState_"):
    """Positions, velocities and efforts of joints, by name."""

    header: Header = field(default_factory=Header)
    name: sequence[str] = field(default_factory=list)
    position: sequence[float64] = field(default_factory=list)
    velocity: sequence[float64] = field(default_factory=list)
    effort: sequence[float64] = field(default_factory=list)


@dataclass
@final
class Imu(IdlStruct, typename="sensor_msgs.msg.dds_.Imu_"):
    """What the inertial sensor reads; a first covariance of -1 says that there is no such reading."""

    header: Header = field(default_factory=Header)
    orientation: Quaternion = field(default_factory=Quaternion)
    orientation_covariance: Nine = field(default_factory=lambda: [0.0] * 9)
    angular_velocity: Vector3 = field(default_factory=Vector3)
    angular_velocity_covariance: Nine = field(default_factory=lambda: [0.0] * 9)
    linear_acceleration: Vector3 = field(default_factory=Vector3)
    linear_acceleration_covariance: Nine = field(default_factory=lambda: [0.0] * 9)


@dataclass
@final
class Odometry(IdlStruct, typename="nav_msgs.msg.dds_.Odometry_"):
    """Where the base is by the robot's own reckoning, and how it moves."""

    header: Header = field(default_factory=Header)
    child_frame_id: str = ""
    pose: PoseWithCovariance = field(default_factory=PoseWithCovariance)
    twist: TwistWithCovariance = field(default_factory=TwistWithCovariance)


@dataclass
@final
class TFMessage(IdlStruct, typename="tf2_msgs.msg.dds_.TFMessage_"):
    """Transforms of one instant."""

    transforms: sequence[TransformStamped] = field(default_factory=list)


@dataclass
@final
class KeyValue(IdlStruct, typename="diagnostic_msgs.msg.dds_.KeyValue_"):
    """A value with its name."""

    key: str = ""
    value: str = ""


@dataclass
@final
class DiagnosticStatus(IdlStruct, typename="diagnostic_msgs.msg.dds_.DiagnosticStatus_"):
    """How one part stands: level 0 fine, 1 a warning, 2 an error."""

    level: uint8 = 0
    name: str = ""
    message: str = ""
    hardware_id: str = ""
    values: sequence[KeyValue] = field(default_factory=list)


@dataclass
@final
class DiagnosticArray(IdlStruct, typename="diagnostic_msgs.msg.dds_.DiagnosticArray_"):
    """How the parts stand at one instant."""

    header: Header = field(default_factory=Header)
    status: sequence[DiagnosticStatus] = field(default_factory=list)


@dataclass
@final
class ObjectHypothesis(IdlStruct, typename="vision_msgs.msg.dds_.ObjectHypothesis_"):
    """What something is, and how surely."""

    class_id: str = ""
    score: float64 = 0.0


@dataclass
@final
class ObjectHypothesisWithPose(IdlStruct, typename="vision_msgs.msg.dds_.ObjectHypothesisWithPose_"):
    """What something is, and where."""

    hypothesis: ObjectHypothesis = field(default_factory=ObjectHypothesis)
    pose: PoseWithCovariance = field(default_factory=PoseWithCovariance)


@dataclass
@final
class BoundingBox3D(IdlStruct, typename="vision_msgs.msg.dds_.BoundingBox3D_"):
    """A box around something."""

    center: Pose = field(default_factory=Pose)
    size: Vector3 = field(default_factory=Vector3)


@dataclass
@final
class Detection3D(IdlStruct, typename="vision_msgs.msg.dds_.Detection3D_"):
    """Something that was seen."""

    header: Header = field(default_factory=Header)
    results: sequence[ObjectHypothesisWithPose] = field(default_factory=list)
    bbox: BoundingBox3D = field(default_factory=BoundingBox3D)
    id: str = ""


@dataclass
@final
class Detection3DArray(IdlStruct, typename="vision_msgs.msg.dds_.Detection3DArray_"):
    """What was seen at one instant."""

    header: Header = field(default_factory=Header)
    detections: sequence[Detection3D] = field(default_factory=list)


@dataclass
@final
class Gid(IdlStruct, typename="rmw_dds_common.msg.dds_.Gid_"):
    """The global id of a DDS entity."""

    data: Sixteen = field(default_factory=lambda: [0] * 16)


@dataclass
@final
class NodeEntitiesInfo(IdlStruct, typename="rmw_dds_common.msg.dds_.NodeEntitiesInfo_"):
    """The readers and writers of one node."""

    node_namespace: str = ""
    node_name: str = ""
    reader_gid_seq: sequence[Gid] = field(default_factory=list)
    writer_gid_seq: sequence[Gid] = field(default_factory=list)


@dataclass
@final
class ParticipantEntitiesInfo(IdlStruct, typename="rmw_dds_common.msg.dds_.ParticipantEntitiesInfo_"):
    """The nodes of one participant: how a node comes into the graph of ROS."""

    gid: Gid = field(default_factory=Gid)
    node_entities_info_seq: sequence[NodeEntitiesInfo] = field(default_factory=list)
