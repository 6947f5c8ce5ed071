"""The definitions that stand in a recording, against another implementation of ROS's."""

import pytest
from cyclonedds.idl import IdlStruct
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

from executive.doors.ros import camera_messages, messages, recorded_messages
from executive.doors.ros.definitions import definition_of
from executive.doors.ros.type_hashes import TYPE_HASHES

KINDS = {
    name: kind
    for module in (messages, camera_messages, recorded_messages)
    for name, kind in vars(module).items()
    if isinstance(kind, type) and issubclass(kind, IdlStruct) and kind is not IdlStruct
    if not kind.__idl_typename__.startswith(
        "rmw_dds_common"
    )  # how nodes are found, and no message of a topic
}
THEIRS = get_typestore(Stores.ROS2_JAZZY)
KNOWN = [name for name, kind in KINDS.items() if definition_of(kind)[0] in THEIRS.fielddefs]


@pytest.mark.parametrize("name", KNOWN)
def test_a_definition_has_the_fields_that_ros_has(name):
    told, text = definition_of(KINDS[name])
    read = get_types_from_msg(text, told)

    assert [(one, kind) for one, kind in read[told][1]] == THEIRS.fielddefs[told][1]


@pytest.mark.parametrize("name", TYPE_HASHES)
def test_a_definition_has_the_hash_that_ros_gives_it(name):
    told, text = definition_of(KINDS[name])
    store = get_typestore(Stores.EMPTY)
    store.register(get_types_from_msg(text, told))

    assert store.hash_rihs01(told) == TYPE_HASHES[name]


def test_messages_that_are_recorded_alone_are_of_ros_too():
    assert {"Log", "CompressedImage", "Float64MultiArray", "MultiArrayLayout"} <= set(KNOWN)
