"""What a hand tells of the thing between its fingers: how wide it is, and where its middle is."""

from __future__ import annotations

import numpy as np

from kinematics.arrays import Array
from kinematics.estimation.held_centre import HeldCentre
from kinematics.geometry.poses import Transform
from robots.perception.fusion.gaussian import Gaussian, Innovation, Measurement
from robots.perception.object_estimate import ObjectEstimate

_OPENING_M = 0.002
"""Of the opening of a grip: encoder, give of the pads, and a thing that is not quite upright between them."""
_CENTRED_M = 0.003
"""Across the opening, the pads centre what they close on."""
_ALONG_PADS_M = 0.025
"""Along the hand, a thing is anywhere on the pads, or just beyond their ends."""
_BESIDE_PADS_M = 0.035
"""And the middle of a tall one is above or below them by as much."""
_REACH_M = 0.002
"""Between where the camera and where the encoders see a hand: encoders, and a body that sways."""


def width_felt(opening_m: float, told_m: float, size_share: float) -> Innovation:
    """Compare the opening of a closed grip with the width that a camera tells.

    Args:
        opening_m: Between the pads.
        told_m: The width of the thing there, as seen.
        size_share: Standard deviation of that, as a share of it.
    """
    seen = Gaussian(np.array([told_m]), np.array([[(size_share * told_m) ** 2]]))
    felt = Measurement("fingers", 0.0, np.array([opening_m]), np.array([[_OPENING_M**2]]), np.eye(1))
    return seen.innovation(felt)


def place_felt(weight: HeldCentre, held_at_m: float = 0.0) -> Gaussian:
    """Where a thing is in the hand that holds it, in the TCP's frame (x ahead, y across the opening).

    Args:
        weight: What was felt of its weight while the hand was at rest.
        held_at_m: Where along the opening the fingers hold its middle.
    """
    middle = np.array([0.0, held_at_m, 0.0])
    fingers = Gaussian(middle, np.diag([_ALONG_PADS_M, _CENTRED_M, _BESIDE_PADS_M]) ** 2)
    found = weight.centre(fingers.mean, fingers.covariance)
    return fingers if found is None else Gaussian(*found)


def compare_places(
    felt: Gaussian, estimate: ObjectEstimate, odom_T_tcp: Transform, stamp_s: float
) -> Innovation | None:
    """Compare where a camera sees a thing with where a hand feels it.

    They are compared along the two directions in which the hand knows the place best: across the opening, and
    across gravity. Along the third, mostly the height at which a thing is held, a hand feels nothing.

    Args:
        felt: Where the hand feels it, in the TCP's frame.
        estimate: What the camera tells.
        odom_T_tcp: The hand at the time of the frames, shape (4, 4).
        stamp_s: That time.

    Returns:
        None when the detector declares no error.
    """
    if estimate.error is None:
        return None
    turn = odom_T_tcp[:3, :3]
    place = turn.T @ (estimate.odom_T_object[:3, 3] - odom_T_tcp[:3, 3])
    error = estimate.error.turned(turn.T).covariance_m2 + _REACH_M**2 * np.eye(3)
    known = _known_directions(felt)
    seen = Measurement("camera", stamp_s, known @ place, known @ error @ known.T, known)
    return felt.innovation(seen)


def place_by_hand(felt: Gaussian, place: Array) -> Array:
    """Where a thing is in the hand, by the hand as far as it feels that, else as it was believed.

    Args:
        felt: Where the hand feels it, in the TCP's frame.
        place: Where it was believed to be there, shape (3,).
    """
    known = _known_directions(felt)
    return np.asarray(place + known.T @ known @ (felt.mean - place))


def _known_directions(felt: Gaussian) -> Array:
    """The two directions in which a hand knows a place best, as rows, shape (2, 3)."""
    _, directions = np.linalg.eigh(felt.covariance)  # the surest first
    return np.asarray(directions[:, :2].T)
