"""``python -m tools.evaluate.perception.learn FILE``: colour classes and confidence from judged pictures.

FILE is what ``python -m tools.evaluate perception --pictures FILE`` keeps. Prints what belongs into
``robots/perception/rgbd/color_classes.py`` and ``confidence.py``.
"""

from __future__ import annotations

import pickle
import sys
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from kinematics.arrays import Array
from robots.perception.rgbd.confidence import FEATURES, RIGHT
from robots.scenes.scene_words import COLORS
from tools.evaluate.perception.judge import PictureRecord, ThingRecord

_LEAST_VISIBLE = 0.25
_FLOOR = (0.008, 0.008, 0.06, 0.09)
"""Standard deviations that no class is narrower than, by feature: tables are lit unevenly."""
_HIGHLIGHT = 0.12
"""How far a highlight draws a colour towards white, as a share of the way."""
_WHITE_HUES = (0.339, 0.327)
_RIDGE = 0.5
_NEAR_M = 0.03


def color_classes(things: Sequence[ThingRecord]) -> tuple[list[str], Array, Array, Array]:
    """Names, means (c, 4), inverse covariances of hues (c, 2, 2), deviations of brightness (c, 2)."""
    names, means, precisions, deviations = list(COLORS), [], [], []
    for name in names:
        some = [thing.features for thing in things if thing.color == name and thing.visible > _LEAST_VISIBLE]
        values = np.array(some)
        middle = np.nanmedian(values, axis=0)
        spread = 1.48 * np.nanmedian(np.abs(values - middle), axis=0) + 0.01
        values = np.where(np.abs(values - middle) < 4.0 * spread, values, np.nan)
        mean = np.nanmean(values, axis=0)
        hues = values[~np.isnan(values[:, :2]).any(axis=1), :2]
        to_white = _HIGHLIGHT * (np.array(_WHITE_HUES) - mean[:2])
        covariance = np.cov(hues.T) + np.diag(np.square(_FLOOR[:2])) + np.outer(to_white, to_white)
        means.append(mean)
        precisions.append(np.linalg.inv(covariance))
        deviations.append(np.hypot(np.nanstd(values[:, 2:], axis=0), _FLOOR[2:]))
    return names, np.array(means), np.array(precisions), np.array(deviations)


def weights(evidence: Array, right: Array) -> Array:
    """Of a logistic regression with a little ridge, the constant first; Newton's method."""
    design = np.column_stack([np.ones(len(evidence)), evidence])
    found = np.zeros(design.shape[1])
    ridge = _RIDGE * np.eye(len(found))
    ridge[0, 0] = 0.0
    for _ in range(50):
        likely = 1.0 / (1.0 + np.exp(-design @ found))
        slope = design.T @ (right - likely) - ridge @ found
        curve = (design * (likely * (1.0 - likely))[:, None]).T @ design + ridge
        found += np.linalg.solve(curve, slope)
    return found


def main(files: Sequence[str]) -> int:
    """Learn from the records in some files."""
    records: list[PictureRecord] = []
    for file in files:
        records += pickle.loads(Path(file).read_bytes())
    things = [thing for record in records for thing in record.things if thing.found]
    names, means, precisions, deviations = color_classes([thing for thing in things if thing.name])
    print(f"COLOR_NAMES = {tuple(names)!r}")
    print(f"MEANS = np.array({np.round(means, 4).tolist()!r})")
    print(f"HUE_PRECISIONS = np.array({np.round(precisions, 1).tolist()!r})")
    print(f"DEVIATIONS = np.array({np.round(deviations, 4).tolist()!r})")
    evidence = np.array([thing.evidence for thing in things])
    right = np.array([thing.right for thing in things], dtype=np.float64)
    real = np.array([bool(thing.name) and thing.position_m < _NEAR_M for thing in things], dtype=np.float64)
    few = [name for name in RIGHT if name != "constant"]
    found = weights(evidence[:, [FEATURES.index(name) for name in few]], right)
    print(f"RIGHT = {dict(zip(('constant', *few), np.round(found, 2).tolist(), strict=True))!r}")
    print(f"THERE = {tuple(np.round(weights(evidence, real), 3).tolist())!r}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
