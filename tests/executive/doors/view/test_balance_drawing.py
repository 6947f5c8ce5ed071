"""How a robot stands, as the page draws it."""

from dataclasses import replace

import numpy as np
import pytest

from executive.doors.view.balance_drawing import balance_of
from kinematics.model.robot_model import RobotModel
from robots.interface.sensed_state import SensedState
from robots.live.documents.robot_report import ReportLayout
from robots.models.description import load_description
from tests.executive.doors.recorder.states import row_at


@pytest.fixture(scope="module")
def model():
    return RobotModel(load_description("talos"))


def walking(model, forces_n, x_m):
    """A report of a robot that stands at home, some way off, in the middle of a walk."""
    report = ReportLayout(model).report(row_at(model, 0.0))
    q = model.q_home.copy()
    q[0] += x_m
    wrench = np.zeros((2, 6))
    wrench[:, 2] = forces_n
    readings = replace(report.sensed.readings, foot_wrench=wrench)
    return replace(report, walking=True, sensed=SensedState(readings, lambda: q.copy()))


def test_while_it_walks_the_area_is_under_the_feet_that_carry(model):
    balance = balance_of(model, walking(model, (400.0, 500.0), 2.0))

    assert balance.polygon[:, 0].mean() == pytest.approx(balance.com[0], abs=0.15)
    assert balance.zmp == pytest.approx(balance.polygon.mean(axis=0), abs=0.1)


def test_a_foot_that_swings_spans_nothing(model):
    both = balance_of(model, walking(model, (400.0, 500.0), 2.0)).polygon
    one = balance_of(model, walking(model, (900.0, 0.0), 2.0)).polygon

    assert np.ptp(one[:, 1]) < 0.6 * np.ptp(both[:, 1])


def test_feet_that_feel_nothing_span_nothing(model):
    balance = balance_of(model, walking(model, (0.0, 0.0), 2.0))

    assert len(balance.polygon) == 0
    assert balance.zmp is None
