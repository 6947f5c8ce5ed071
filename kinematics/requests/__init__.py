"""What a planner is asked and what it answers, one module for each kind."""

from typing import TYPE_CHECKING

from kinematics.handed_on import handed_on

if TYPE_CHECKING:
    from kinematics.requests.check import CheckRequest
    from kinematics.requests.gesture import (
        CarryRequest,
        OfferRequest,
        PointRequest,
        RaiseHandRequest,
        SwingRequest,
    )
    from kinematics.requests.grasp import Grasp
    from kinematics.requests.handle import HandlePlan, HandleRequest
    from kinematics.requests.move import MovePlan, MoveRequest, RetreatRequest
    from kinematics.requests.pick import PickPlan, PickRequest
    from kinematics.requests.place import PlacePlan, PlaceRequest, Spot
    from kinematics.requests.request import Request
    from kinematics.requests.step import NoPlan, PlannedStep, WhyNoPlan
    from kinematics.requests.view import ViewRequest
else:
    __getattr__ = handed_on(
        __name__,
        {
            "CarryRequest": "gesture",
            "CheckRequest": "check",
            "Grasp": "grasp",
            "HandlePlan": "handle",
            "HandleRequest": "handle",
            "MovePlan": "move",
            "MoveRequest": "move",
            "NoPlan": "step",
            "OfferRequest": "gesture",
            "PickPlan": "pick",
            "PickRequest": "pick",
            "PlacePlan": "place",
            "PlaceRequest": "place",
            "PlannedStep": "step",
            "PointRequest": "gesture",
            "RaiseHandRequest": "gesture",
            "Request": "request",
            "RetreatRequest": "move",
            "Spot": "place",
            "SwingRequest": "gesture",
            "ViewRequest": "view",
            "WhyNoPlan": "step",
        },
    )

__all__ = [
    "CarryRequest",
    "CheckRequest",
    "Grasp",
    "HandlePlan",
    "HandleRequest",
    "MovePlan",
    "MoveRequest",
    "NoPlan",
    "OfferRequest",
    "PickPlan",
    "PickRequest",
    "PlacePlan",
    "PlaceRequest",
    "PlannedStep",
    "PointRequest",
    "RaiseHandRequest",
    "Request",
    "RetreatRequest",
    "Spot",
    "SwingRequest",
    "ViewRequest",
    "WhyNoPlan",
]
