"""Stored trajectories: written exactly, read strictly."""

import copy
import json
from pathlib import Path

import jsonschema
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from kinematics.errors import TrajectoryDocumentError
from kinematics.formats.trajectory_document import (
    MAX_POSITION,
    MAX_VELOCITY,
    HeldObject,
    StoredTrajectory,
    read_trajectory,
    write_trajectory,
)
from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball, Box, Cylinder
from kinematics.model.stance import Stance
from kinematics.motion.trajectory import Trajectory
from kinematics.scene.planning_scene import SceneObject
from tests.kinematics.parts_of_things import random_parts

SCHEMA = json.loads((Path(__file__).parents[3] / "docs" / "reference" / "trajectory.schema.json").read_text())

names = st.text(st.characters(codec="utf-8", exclude_categories=("Cs",)), min_size=1, max_size=12).filter(
    lambda text: text.strip()
)
lengths = st.floats(0.001, 5.0)
parts = st.one_of(
    st.none(),
    st.builds(
        lambda seed, key: random_parts(np.random.default_rng(seed), key).parts, st.integers(0, 99), names
    ),
)
shapes = st.one_of(
    st.builds(lambda x, y, z, parts: Box((x, y, z), parts), lengths, lengths, lengths, parts),
    st.builds(Cylinder, lengths, lengths, parts),
    st.builds(Ball, lengths, parts),
)


def pose(x, y, z, turn):
    return poses.transform(poses.rotation_from_vector(turn), (x, y, z))


places = st.builds(pose, *[st.floats(-9.0, 9.0)] * 3, arrays(float, 3, elements=st.floats(-1.7, 1.7)))


@st.composite
def stored_trajectories(draw):
    joints = tuple(draw(st.lists(names, max_size=4, unique=True)))
    spacing = draw(st.lists(st.floats(1e-5, 1.0), min_size=1, max_size=5))
    t_s = np.concatenate([[0.0], np.cumsum(spacing)])
    bounded = st.floats(-MAX_POSITION, MAX_POSITION)
    q = draw(arrays(float, (len(t_s), 7 + len(joints)), elements=bounded))
    q[:, 3] += np.where(np.linalg.norm(q[:, 3:7], axis=1) < 0.1, 1.0, 0.0)
    v = draw(arrays(float, (len(t_s), 6 + len(joints)), elements=st.floats(-MAX_VELOCITY, MAX_VELOCITY)))
    soles = draw(st.dictionaries(names, places, max_size=2))
    held = draw(
        st.lists(
            st.builds(
                HeldObject,
                names,
                names,
                places,
                shapes,
                st.frozensets(names, max_size=2),
                st.floats(0.0, 5.0),
            ),
            max_size=2,
            unique_by=lambda item: item.name,
        )
    )
    pairs = draw(st.frozensets(st.frozensets(names, min_size=2, max_size=2), max_size=2))
    objects = draw(
        st.none()
        | st.lists(
            st.builds(SceneObject, names, shapes, places, st.floats(0.0, 0.1)),
            max_size=2,
            unique_by=lambda item: item.name,
        ).map(tuple)
    )
    motion = Trajectory(joints, Stance(tuple(soles.items())), t_s, q, v)
    return StoredTrajectory(draw(names), motion, tuple(held), pairs, objects)


def same_places(first, second):
    return all(np.allclose(a, b, atol=1e-12) for a, b in zip(first, second, strict=True))


@given(stored_trajectories())
def test_what_was_written_is_read_back(stored):
    text = write_trajectory(stored)

    back = read_trajectory(text)

    ours, theirs = stored.trajectory, back.trajectory
    assert (back.robot, theirs.joints, back.allowed) == (stored.robot, ours.joints, stored.allowed)
    for name in ("t_s", "q", "v"):
        assert getattr(theirs, name).tobytes() == getattr(ours, name).tobytes()
    assert [frame for frame, _ in theirs.stance.soles] == [frame for frame, _ in ours.stance.soles]
    assert same_places([place for _, place in theirs.stance.soles], [place for _, place in ours.stance.soles])
    assert [(h.name, h.frame, h.shape, h.touch_links, h.mass_kg) for h in back.held] == [
        (h.name, h.frame, h.shape, h.touch_links, h.mass_kg) for h in stored.held
    ]
    assert (back.objects is None) == (stored.objects is None)
    assert [(o.name, o.shape, o.margin_m) for o in back.objects or ()] == [
        (o.name, o.shape, o.margin_m) for o in stored.objects or ()
    ]
    assert same_places(
        [o.world_T_object for o in back.objects or ()], [o.world_T_object for o in stored.objects or ()]
    )
    assert same_places([h.frame_T_object for h in back.held], [h.frame_T_object for h in stored.held])


@given(stored_trajectories())
def test_what_was_written_keeps_to_the_published_schema(stored):
    jsonschema.validate(json.loads(write_trajectory(stored)), SCHEMA)


def document():
    still = {"position_m": [0, 0, 0], "quaternion_xyzw": [0, 0, 0, 1]}
    q, v = [0, 0, 1, 0, 0, 0, 1, 0.1, 0.2], [0] * 8
    return {
        "schema": 1,
        "robot": "r2",
        "joints": ["elbow", "wrist"],
        "stance": {"left_sole": copy.deepcopy(still)},
        "samples": [{"t_s": t_s, "q": list(q), "v": list(v)} for t_s in (0, 0.01, 0.02)],
        "held": [{"name": "cup", "frame": "hand", "shape": {"kind": "ball", "radius_m": 0.03}, **still}],
        "allowed": [["cup", "hand"]],
        "objects": [{"name": "ball", "shape": {"kind": "ball", "radius_m": 0.03}, **copy.deepcopy(still)}],
    }


def test_the_plain_document_is_read():
    stored = read_trajectory(json.dumps(document()))

    assert stored.trajectory.duration_s == 0.02
    assert stored.held[0].touch_links == frozenset()


def changed(path, value):
    root = document()
    *way, last = path
    node = root
    for step in way:
        node = node[step]
    if value is ...:
        del node[last]
    else:
        node[last] = value
    return root


BROKEN = [
    (("schema",), 2, "schema: must be 1"),
    (("schema",), True, "schema: must be 1"),
    (("schema",), 1.0, "schema: must be 1"),
    (("robot",), ..., "document: 'robot' is missing"),
    (("robot",), "", "robot: must be a text"),
    (("sampels",), [], "did you mean 'samples'?"),
    (("joints",), ["elbow", "elbow"], "'elbow' is there twice"),
    (("joints",), ["elbow"], "samples[0].q: must have 8 numbers, not 9"),
    (("stance",), [], "stance: must be an object"),
    (("stance", "left_sole", "quaternion_xyzw"), [0, 0, 0, 1.1], "must have length 1, not 1.1"),
    (("stance", "left_sole", "position_m"), [0, 0], "stance.left_sole.position_m: must have 3 numbers"),
    (("samples",), [], "samples: must have 2 to 100000 entries, not 0"),
    (("samples", 0, "t_s"), 0.001, "samples[0].t_s: the first sample is at 0"),
    (("samples", 2, "t_s"), 0.01, "samples[2].t_s: must be at least 1e-06 s after 0.01"),
    (("samples", 2, "t_s"), 601, "samples[2].t_s: must be a finite number within ±600"),
    (("samples", 1, "q"), ..., "samples[1]: 'q' is missing"),
    (("samples", 1, "q", 8), "x", "samples[1].q[8] (wrist): must be a number"),
    (("samples", 1, "q", 8), True, "samples[1].q[8] (wrist): must be a number, not true"),
    (("samples", 1, "q", 7), None, "samples[1].q[7] (elbow): must be a number, not null"),
    (("samples", 1, "q", 7), float("nan"), "samples[1].q[7] (elbow): must be a finite number"),
    (("samples", 1, "q", 2), float("inf"), "samples[1].q[2] (base z): must be a finite number"),
    (("samples", 1, "v", 7), 1e5, "samples[1].v[7] (wrist): must be a finite number within ±10000"),
    (("samples", 1, "v", 0), 10**400, "samples[1].v[0] (base velocity x): must be a finite number"),
    (("samples", 1, "q"), [0] * 9, "samples[1].q: the base quaternion (3 to 6) vanishes"),
    (("samples", 1, "a"), [], "samples[1]: unknown key"),
    (("held", 0, "shape", "kind"), "bal", "held[0].shape.kind: must be one of box, cylinder, ball"),
    (("held", 0, "shape", "kind"), [], "held[0].shape.kind: must be one of"),
    (("held", 0, "shape", "radius_m"), 0, "held[0].shape.radius_m: must be above 0"),
    (("held", 0, "shape"), {"kind": "box", "size_m": [1, 1, -1]}, "size_m[2] (z): must be above 0"),
    (("held", 0, "mass_kg"), -1.0, "held[0].mass_kg: must be 0 or more, not -1.0"),
    (("held", 0, "touch_links"), [3], "held[0].touch_links[0]: must be a text"),
    (("allowed",), [["cup", "cup"]], "allowed[0]: 'cup' cannot touch itself"),
    (("objects", 0, "margin_m"), -0.1, "objects[0].margin_m: must be 0 or more"),
    (("objects", 0, "name"), "", "objects[0].name: must be a text"),
    (("allowed",), [["cup"]], "allowed[0]: must have 2 entries, not 1"),
]


@pytest.mark.parametrize(("path", "value", "says"), BROKEN)
def test_a_broken_document_is_refused_with_place_and_reason(path, value, says):
    with pytest.raises(TrajectoryDocumentError) as refused:
        read_trajectory(json.dumps(changed(path, value)))

    assert says in str(refused.value)


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("", "is no JSON"),
        ("[]", "must be an object, not a list"),
        ("null", "must be an object, not null"),
        ("[" * 100_000, "nested too deeply"),
        ('{"schema": 1, "schema": 1}', "'schema' is there twice"),
        ('{"schema": ' + "1" * 5000 + "}", "is no JSON"),
        ("\x00", "is no JSON"),
    ],
)
def test_what_is_no_document_is_refused(text, says):
    with pytest.raises(TrajectoryDocumentError, match=says):
        read_trajectory(text)


@given(
    st.recursive(
        st.none() | st.booleans() | st.floats() | st.text(),
        lambda c: st.lists(c) | st.dictionaries(st.text(), c),
    )
)
def test_no_value_anywhere_ends_in_another_error(value):
    for path in [
        ("samples",),
        ("samples", 1),
        ("samples", 1, "q"),
        ("held",),
        ("held", 0),
        ("allowed",),
        ("stance",),
    ]:
        try:
            read_trajectory(json.dumps(changed(path, value)))
        except TrajectoryDocumentError:
            continue
