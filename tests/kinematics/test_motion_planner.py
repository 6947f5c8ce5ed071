import importlib
import pkgutil
import typing

import pytest

import kinematics.requests
from kinematics.motion_planner import MotionPlanner, planners
from kinematics.requests.check import CheckRequest
from kinematics.requests.request import Request
from kinematics.scene.planning_scene import PlanningScene

MODULES = [
    importlib.import_module(f"kinematics.requests.{found.name}")
    for found in pkgutil.iter_modules(kinematics.requests.__path__)
]
# a dataclass with slots is made twice, and only one of the two can be found by its name
KINDS = [kind for kind in Request.__subclasses__() for module in MODULES if kind in vars(module).values()]
KINDS = list(dict.fromkeys(KINDS))


def answers_of(kind):
    """What a kind of request says that it is answered by."""
    (base,) = kind.__orig_bases__
    return set(typing.get_args(typing.get_args(base)[0]))


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.__name__)
def test_a_planner_answers_as_its_request_says(talos, kind):
    plan = planners(talos)[kind]
    hints = typing.get_type_hints(getattr(plan, "func", plan))

    assert set(typing.get_args(hints["return"])) == answers_of(kind)


def test_every_kind_of_request_is_looked_at():
    assert len(KINDS) == 13


def test_a_check_is_no_planning(talos):
    with pytest.raises(TypeError, match="no planner answers a CheckRequest; requests are CarryRequest"):
        MotionPlanner(talos).answer(CheckRequest(None, PlanningScene()))
