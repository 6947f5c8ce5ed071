"""Two cameras' calibrations against each other: what all that both show is apart by, they are wrong by."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from kinematics.arrays import Array, Sealed
from robots.perception.object_estimate import ObjectEstimate
from robots.perception.position_error import PositionError

NEAR_M = 0.8
"""A turn of a camera moves what is farther apart than this otherwise."""


@dataclass(frozen=True, slots=True)
class Registration(Sealed):
    """How one camera's things are to be moved.

    Attributes:
        shift_m: By so much, shape (3,).
        gain: Share of what both are apart that this camera is taken to be wrong by, shape (3, 3).
        added_m2: What that takes over of the other camera's error, and of the noise of the comparison.
        middle_m: Where the things are that were compared.
    """

    shift_m: Array
    gain: Array
    added_m2: Array
    middle_m: Array

    def moved(self, estimate: ObjectEstimate) -> ObjectEstimate:
        """A thing of this camera, with what is known of its calibration now."""
        error = estimate.error
        away_m = np.linalg.norm(estimate.odom_T_object[:3, 3] - self.middle_m)
        if error is None or not error.shared_m2.any() or away_m > NEAR_M:
            return estimate
        kept = np.eye(3) - self.gain
        shared = kept @ error.shared_m2 @ kept.T + self.added_m2
        lasting = error.lasting_m2 - error.shared_m2 + shared
        pose = estimate.odom_T_object.copy()
        pose[:3, 3] += self.shift_m
        return replace(
            estimate,
            odom_T_object=pose,
            error=PositionError(lasting, error.noise_m2, error.size_share, shared),
        )


def registrations(
    pairs: Sequence[tuple[ObjectEstimate, ObjectEstimate]],
) -> tuple[Registration, Registration] | None:
    """How two cameras' things are to be moved, the first one's and the second one's.

    The errors that each camera's things share are estimated from the mean of what things that both show are
    apart by, weighed by what each thing may be wrong by for itself (a Kalman update of both calibrations).

    Args:
        pairs: Things that both show, and agree on.

    Returns:
        None where nothing can be learned: no pair, or nothing that a camera's things share.
    """
    told = [(a, b, a.error, b.error) for a, b in pairs if a.error is not None and b.error is not None]
    if not told or not any(one.shared_m2.any() or other.shared_m2.any() for _, _, one, other in told):
        return None
    weights = [np.linalg.inv(one.own_m2 + other.own_m2) for _, _, one, other in told]
    noise = np.linalg.inv(np.sum(weights, axis=0))
    apart = [
        weight @ (b.odom_T_object[:3, 3] - a.odom_T_object[:3, 3])
        for (a, b, _, _), weight in zip(told, weights, strict=True)
    ]
    difference = noise @ np.sum(apart, axis=0)
    middle = np.mean([a.odom_T_object[:3, 3] for a, _, _, _ in told], axis=0)
    first = np.mean([one.shared_m2 for _, _, one, _ in told], axis=0)
    second = np.mean([other.shared_m2 for _, _, _, other in told], axis=0)
    whole = np.linalg.inv(first + second + noise)
    of_first, of_second = first @ whole, second @ whole
    return (
        Registration(of_first @ difference, of_first, of_first @ (second + noise) @ of_first.T, middle),
        Registration(-of_second @ difference, of_second, of_second @ (first + noise) @ of_second.T, middle),
    )
