"""Tells things by the views that somebody showed: local features and colours, with a margin."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from kinematics.arrays import Array
from robots.perception.labels.labeller import Boxes, Image
from robots.perception.labels.look import Look, finder, look_of
from robots.perception.labels.views import View, view_of

WEIGHTS = (-50.5, 57.3, 23.4, 9.1, 0.2)
"""Of a logistic regression on random packages: the constant, then ``evidence``."""
_COLOR = 10.0
"""What colours weigh beside local features where two things are compared."""
_APART = 15.0
"""A thing that fits by a fifteenth better than another is e times as likely."""
_LEAST_PX = 150


class ShownLabeller:
    """A ``Labeller`` that has seen its things before.

    Args:
        views: Of each thing, by its name.
    """

    def __init__(self, views: Mapping[str, Sequence[View]]) -> None:
        self._sift = finder()
        self._looks = {name: [look_of(view, self._sift) for view in some] for name, some in views.items()}
        self._names = sorted(self._looks)
        looks = [(k, look) for k, name in enumerate(self._names) for look in self._looks[name]]
        self._owner = np.array([k for k, _ in looks], dtype=np.int64)
        self._colors = np.sqrt(np.array([look.colors for _, look in looks])) if looks else np.zeros((0, 0, 0))
        self._points = np.concatenate([look.points for _, look in looks]) if looks else np.zeros((0, 128))
        self._heights = np.concatenate([look.places[:, 0] for _, look in looks]) if looks else np.zeros(0)
        self._point_owner = np.concatenate(
            [np.full(len(look.points), k, dtype=np.int64) for k, look in looks] or [np.zeros(0, np.int64)]
        )

    @property
    def words(self) -> frozenset[str]:
        """The names of what was shown."""
        return frozenset(self._names)

    @property
    def trouble(self) -> str:
        """None, ever."""
        return ""

    def scores(self, image: Image, boxes: Boxes, words: Sequence[str]) -> Array:
        """How surely each box shows each thing; see ``Labeller``."""
        found = np.zeros((len(boxes), len(words)))
        columns = [
            (column, self._names.index(word)) for column, word in enumerate(words) if word in self._looks
        ]
        if not columns:
            return found
        for k in range(len(boxes)):
            if boxes.mask(k).sum() < _LEAST_PX:
                continue
            told = self.judge(look_of(view_of(image, boxes, k), self._sift))
            for column, name in columns:
                found[k, column] = told[name]
        return found

    def judge(self, look: Look) -> Array:
        """How surely a look is that of each thing, in the order of the names, shape (n,)."""
        color, local = self._alike(look), self._nearer(look)
        _, evidence = _evidence(color, local)
        sure = _share(WEIGHTS[0] + float(np.dot(evidence, WEIGHTS[1:])))
        # things that look the same share what is sure
        total = _COLOR * color + local
        odds = np.exp(np.clip(_APART * (total - total.max()), -50.0, 0.0))
        return np.asarray(sure * odds / odds.sum())

    def evidence(self, look: Look) -> tuple[int, Array]:
        """Which thing a look fits best, and what speaks for it.

        Returns:
            Its number, and: how alike its colours are, and by how much more than those of the second best;
            how far local features are nearer to it than to any other, and by how much more than to the
            second.
        """
        return _evidence(self._alike(look), self._nearer(look))

    def _alike(self, look: Look) -> Array:
        """Of each thing, how alike the colours of its likeliest view are: 1 is the same."""
        views = (self._colors * np.sqrt(look.colors)[None]).sum(axis=2).mean(axis=1)
        best = np.zeros(len(self._names))
        np.maximum.at(best, self._owner, views)
        return best

    def _nearer(self, look: Look) -> Array:
        """Of each thing, how much nearer it is to the look's local features than the others are.

        Each feature speaks for the thing that has the nearest one at about its height, by the difference to
        the nearest one of any other thing (McCann and Lowe 2012).
        """
        count = len(self._names)
        score = np.zeros(count)
        if not len(look.points) or not len(self._points):
            return score
        distance = 2.0 - 2.0 * (look.points @ self._points.T)
        distance += np.where(np.abs(look.places[:, :1] - self._heights[None]) > 0.15, 0.6, 0.0)
        nearest = np.full((len(look.points), count), 2.0)
        order = np.argsort(self._point_owner, kind="stable")
        owners, first = np.unique(self._point_owner[order], return_index=True)
        nearest[:, owners] = np.minimum.reduceat(distance[:, order], first, axis=1)
        if count == 1:
            score[0] = float(np.maximum(0.7 - nearest[:, 0], 0.0).sum())
            return np.asarray(score / len(look.points) ** 0.5)
        two = np.partition(nearest, 1, axis=1)
        gain = two[:, 1] - two[:, 0]
        np.add.at(score, nearest.argmin(axis=1), np.where(two[:, 0] < 0.9, gain, 0.0))
        return np.asarray(score / len(look.points) ** 0.5)


def _share(odds: float) -> float:
    return float(1.0 / (1.0 + np.exp(-np.clip(odds, -50.0, 50.0))))


def _evidence(color: Array, local: Array) -> tuple[int, Array]:
    total = _COLOR * color + local
    best = int(np.argmax(total))
    others = np.delete(np.arange(len(total)), best)
    next_color = float(color[others].max()) if len(others) else 0.0
    next_local = float(local[others].max()) if len(others) else 0.0
    return best, np.array([color[best], color[best] - next_color, local[best], local[best] - next_local])
