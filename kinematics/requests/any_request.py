"""What one can ask of the motion planner and the checker, and what they answer.

All are frozen values, so that they can be sent to a worker process.
"""

from __future__ import annotations

from kinematics.requests.check import CheckRequest
from kinematics.requests.gesture import GestureRequest
from kinematics.requests.handle import HandleRequest
from kinematics.requests.move import MoveRequest, RetreatRequest
from kinematics.requests.pick import PickRequest
from kinematics.requests.place import PlaceRequest
from kinematics.requests.view import ViewRequest

PlanRequest = (
    PickRequest
    | MoveRequest
    | RetreatRequest
    | HandleRequest
    | PlaceRequest
    | GestureRequest
    | ViewRequest
    | CheckRequest
)
