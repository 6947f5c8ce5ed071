import importlib
import pkgutil
import typing

import pytest

import kinematics.requests
from kinematics.motion_planner import MotionPlanner, planners
from kinematics.requests.check import CheckRequest
from kinematics.requests.request import Request
from kinematics.scene.planning_scene import PlanningScene

for module in pkgutil.iter_modules(kinematics.requests.__path__):
    importlib.import_module(f"kinematics.requests.{module.name}")
KINDS = Request.__subclasses__()


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
    assert len(KINDS) == 11


def test_a_check_is_no_planning(talos):
    with pytest.raises(TypeError, match="no planner answers a CheckRequest; requests are CarryRequest"):
        MotionPlanner(talos).answer(CheckRequest(None, PlanningScene()))
