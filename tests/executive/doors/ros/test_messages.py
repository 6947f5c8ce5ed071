"""The messages on the wire, byte for byte against another implementation of ROS's definitions."""

import dataclasses

import numpy as np
import pytest
from cyclonedds.idl import IdlStruct
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

from executive.doors.ros import camera_messages, messages
from executive.doors.ros.type_hashes import TYPE_HASHES

pytestmark = pytest.mark.requirement("U3")

VISION = {
    "ObjectHypothesis": "string class_id\nfloat64 score\n",
    "ObjectHypothesisWithPose": "ObjectHypothesis hypothesis\ngeometry_msgs/PoseWithCovariance pose\n",
    "BoundingBox3D": "geometry_msgs/Pose center\ngeometry_msgs/Vector3 size\n",
    "Detection3D": "std_msgs/Header header\nObjectHypothesisWithPose[] results\n"
    "BoundingBox3D bbox\nstring id\n",
    "Detection3DArray": "std_msgs/Header header\nDetection3D[] detections\n",
}
"""Definitions of vision_msgs, which the other implementation does not bring."""
KINDS = [
    kind
    for kind in {**vars(messages), **vars(camera_messages)}.values()
    if isinstance(kind, type) and issubclass(kind, IdlStruct) and kind is not IdlStruct
]


def store(which):
    made = get_typestore(which)
    for name, text in VISION.items():
        made.register(get_types_from_msg(text, f"vision_msgs/msg/{name}"))
    return made


@pytest.fixture(scope="module", params=[Stores.ROS2_JAZZY, Stores.ROS2_KILTED], ids=lambda one: one.value)
def other(request):
    return store(request.param)


def ros_name(kind):
    return kind.__idl_typename__.replace(".msg.dds_.", "/msg/")[:-1]


def drawn(kind, rng, depth=0):
    """A message of this kind with random values in every field, and the same for the other side."""
    if kind is str:
        return "".join(rng.choice(list("aé_ 9字"), rng.integers(0, 9)))
    return kind(**{field.name: value(kind, field, rng, depth) for field in dataclasses.fields(kind)})


def value(kind, field, rng, depth):
    usual = getattr(kind(), field.name)
    match usual:
        case bool():
            return bool(rng.integers(2))
        case int():
            return int(rng.integers(0, 2 if field.name in ("level", "is_bigendian") else 2**31))
        case float():
            return float(rng.normal())
        case str():
            return drawn(str, rng)
        case [*numbers] if numbers:
            whole = isinstance(numbers[0], int)
            return [int(rng.integers(256)) if whole else float(rng.normal()) for _ in numbers]
        case []:
            return [element(kind, field.name, rng, depth) for _ in range(rng.integers(0, 4))]
        case _:
            return drawn(type(usual), rng, depth + 1)


ELEMENTS = {
    ("JointState", "name"): str,
    ("TFMessage", "transforms"): messages.TransformStamped,
    ("DiagnosticStatus", "values"): messages.KeyValue,
    ("DiagnosticArray", "status"): messages.DiagnosticStatus,
    ("Detection3D", "results"): messages.ObjectHypothesisWithPose,
    ("Detection3DArray", "detections"): messages.Detection3D,
    ("NodeEntitiesInfo", "reader_gid_seq"): messages.Gid,
    ("NodeEntitiesInfo", "writer_gid_seq"): messages.Gid,
    ("ParticipantEntitiesInfo", "node_entities_info_seq"): messages.NodeEntitiesInfo,
}


def element(kind, name, rng, depth):
    if kind is camera_messages.Image:
        return int(rng.integers(256))
    of = ELEMENTS.get((kind.__name__, name))
    return float(rng.normal()) if of is None else drawn(of, rng, depth + 1)


def as_other(message, types):
    """The same message as the other side makes it."""
    made = types[ros_name(type(message))]
    values = {}
    for field in dataclasses.fields(message):
        one = getattr(message, field.name)
        if isinstance(one, IdlStruct):
            one = as_other(one, types)
        elif isinstance(one, list) and one and isinstance(one[0], IdlStruct):
            one = [as_other(each, types) for each in one]
        elif isinstance(one, list) and (not one or isinstance(one[0], (int, float))):
            is_bytes = type(message) in (messages.Gid, camera_messages.Image)
            one = (
                one
                if (type(message).__name__, field.name) in ELEMENTS
                else np.array(one, dtype=np.uint8 if is_bytes else np.float64)
            )
        values[field.name] = one
    return made(**values)


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.__name__)
def test_random_messages_are_the_same_bytes_on_both_sides(kind, other):
    rng = np.random.default_rng(41)
    for _ in range(20):
        message = drawn(kind, rng)
        theirs = other.serialize_cdr(as_other(message, other.types), ros_name(kind))
        assert message.serialize() == bytes(theirs)
        assert kind.deserialize(bytes(theirs)).serialize() == message.serialize()


@pytest.mark.parametrize(
    "kind", [one for one in KINDS if one.__name__ in TYPE_HASHES], ids=lambda one: one.__name__
)
def test_the_hash_of_a_type_is_the_one_that_ros_has(kind, other):
    assert TYPE_HASHES[kind.__name__] == other.hash_rihs01(ros_name(kind))


@pytest.mark.parametrize("length", [0, 1, 3, 4, 921_600])
def test_pixels_that_are_bytes_already_are_the_same_on_the_wire(other, length):
    rng = np.random.default_rng(length)
    pixels = rng.integers(0, 256, length, dtype=np.uint8)
    message = drawn(camera_messages.Image, rng)
    message.data = pixels.tobytes()
    listed = dataclasses.replace(message, data=pixels.tolist())

    theirs = other.serialize_cdr(as_other(listed, other.types), "sensor_msgs/msg/Image")

    assert message.serialize() == listed.serialize() == bytes(theirs)
