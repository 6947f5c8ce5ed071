"""Numbers of one kind in one piece, and values that nobody can change."""

from __future__ import annotations

import copy
import importlib
import pickle
import pkgutil
from dataclasses import FrozenInstanceError, dataclass, fields, is_dataclass, replace

import numpy as np
import pytest

from kinematics.arrays import Array, InFloat64, Sealed, as_float64, sealed
from kinematics.errors import InvalidArrayError


@dataclass(frozen=True, slots=True)
class Noted(Sealed):
    name: str
    q: Array
    v: Array | None = None


def test_what_is_plain_already_is_not_copied():
    plain = np.zeros((3, 4))

    assert as_float64(plain) is plain


@pytest.mark.parametrize("shape", [(3,), (None,), (3, 5), (4, None), ()])
def test_another_shape_is_refused_with_both(shape):
    with pytest.raises(InvalidArrayError, match=r"^q has shape \(3, 4\), not \("):
        as_float64(np.zeros((3, 4)), shape, "q")


def test_ragged_rows_are_no_array():
    with pytest.raises(InvalidArrayError, match=r"^q is no array"):
        as_float64([[1.0], [1.0, 2.0]], what="q")


def test_what_is_sealed_cannot_be_written_through_anything_that_leads_to_it():
    kept = sealed(np.arange(6.0).reshape(2, 3))

    views = [kept, kept[0], kept.T, kept.reshape(-1), np.asarray(kept)]
    for view in views:
        with pytest.raises(ValueError, match="WRITEABLE"):
            view.setflags(write=True)
        with pytest.raises(ValueError, match="read-only"):
            view[...] = 0.0
    assert isinstance(kept.base, bytes)


def test_what_is_sealed_already_is_not_copied():
    kept = sealed([1.0, 2.0])

    assert sealed(kept) is kept
    assert sealed(kept[:1]) is not kept


@pytest.mark.parametrize("shape", [(0,), (0, 7), (2, 0)])
def test_empty_arrays_are_sealed_as_others(shape):
    assert sealed(np.zeros(shape)).shape == shape


def test_who_gave_an_array_cannot_change_what_was_kept_of_it():
    own = np.zeros(3)
    value = Noted("n", own)

    own[0] = 1.0

    assert value.q.tolist() == [0.0, 0.0, 0.0]
    assert value.v is None


@pytest.mark.parametrize("again", [copy.copy, copy.deepcopy, lambda value: replace(value, name="m"),
                                   lambda value: pickle.loads(pickle.dumps(value))])  # fmt: skip
def test_a_copy_is_sealed_as_well(again):
    value = again(Noted("n", np.zeros(3), np.ones(2)))

    assert isinstance(value.q.base, bytes)
    assert isinstance(value.v.base, bytes)
    with pytest.raises(FrozenInstanceError):
        value.q = np.zeros(3)


# Intermediate results of one computation, which never leave the room that makes them: they are filled,
# cut and handed to compiled code.
WORKING = {
    "kinematics.ik.arm_frames.ArmFrames",
    "kinematics.checking.kinematics.BodyPoses",
    "kinematics.checking.pairs.Pairs",
    "kinematics.checking.solids.Solid",
    "kinematics.checking.timeline.Configurations",
    "kinematics.timing.curve_speed.CurveGrid",
    "kinematics.planning.gesture_task.Wish",
    "kinematics.planning.grasps.GraspTable",
    "kinematics.distance.solids.Solid",
    "kinematics.standing.leg_ik.LegGeometry",
    "kinematics.standing.numeric_leg.LegChain",
    "kinematics.planning.pick_task.Way",
    "kinematics.planning.place_task.PlaceGoal",
    "kinematics.motion.sampler.MotionSample",
    "kinematics.walking.body.foot_wrenches.SoleWrench",
    "kinematics.walking.body.legged_estimator.ComEstimate",
    "kinematics.walking.route.ways.WayFinder",
    "robots.control.gate.proposal.Proposal",
    "robots.simulated.truth.true_contacts.PadContact",
}


def frozen_values():
    for root in ("kinematics", "robots", "trees", "executive"):
        for module in pkgutil.walk_packages(importlib.import_module(root).__path__, f"{root}."):
            if module.name.endswith("__main__") or ".ros.node." in module.name:  # which needs ROS
                continue
            found = importlib.import_module(module.name)
            for kind in vars(found).values():
                if isinstance(kind, type) and kind.__module__ == module.name and is_dataclass(kind):
                    yield kind


def holds_arrays(kind):
    types = [field.type.removeprefix("poses.") for field in fields(kind) if isinstance(field.type, str)]
    return any(name.startswith(("Array", "Transform", "NDArray[")) for name in types)


def test_every_frozen_value_that_is_handed_on_seals_its_arrays():
    open_values = {
        f"{kind.__module__}.{kind.__qualname__}"
        for kind in frozen_values()
        if kind.__dataclass_params__.frozen
        and not kind.__name__.startswith("_")
        and holds_arrays(kind)
        and not issubclass(kind, Sealed | InFloat64)
    }

    assert open_values == WORKING
