"""Has a model say what crops of a picture show."""

from __future__ import annotations

import base64
import json
from collections.abc import Sequence
from typing import Any

import cv2
import numpy as np

from kinematics.arrays import Array
from robots.perception.labels.asking import AskAboutPictures, SilentModelError
from robots.perception.labels.labeller import Boxes, Image

_MOST_FAILURES = 3
"""Questions in a row without a good answer, after which a model is asked no more: each may take its time."""
_MOST_BOXES = 16
_SAME_SHARE = 0.75
_REMEMBERED = 64
_ROOM_PX = 6
_LONG_PX = 256
_PROMPT = (
    "Each picture shows one thing on a table. For each picture say which of these labels fits it best, or "
    'none, and how sure you are. Labels: {labels}. Answer with JSON alone: {{"answers": [{{"picture": 1, '
    '"label": "...", "score": 0.0}}]}}; score is between 0 and 1.'
)


class VisionLabeller:
    """A ``Labeller`` that asks a model once for each thing, and keeps the answer while that stays in place.

    A model that gives no answer, or another than was asked for, tells nothing: the others go on.

    Args:
        ask: Asks the model.

    Attributes:
        trouble: Why the last question had no good answer; empty else.
    """

    def __init__(self, ask: AskAboutPictures) -> None:
        self._ask, self._failures = ask, 0
        self._known: list[tuple[tuple[str, ...], Array, Array, Array]] = []
        self.trouble = ""

    @property
    def words(self) -> None:
        """Any."""
        return

    def scores(self, image: Image, boxes: Boxes, words: Sequence[str]) -> Array:
        """What the model says; see ``Labeller``."""
        told = np.zeros((len(boxes), len(words)))
        asked = tuple(words)
        new: list[tuple[int, Array]] = []
        for k in range(len(boxes)):
            look = _mean(image, boxes, k)
            answer = self._remembered(asked, boxes.places[k], look)
            if answer is None and len(new) < _MOST_BOXES:
                new.append((k, look))
            elif answer is not None:
                told[k] = answer
        if new and self._failures < _MOST_FAILURES:
            answers = self._asked(image, boxes, [k for k, _ in new], asked)
            if answers is not None:
                for (k, look), row in zip(new, answers, strict=True):
                    told[k] = row
                    self._known.append((asked, boxes.places[k].astype(np.float64), look, row))
                self._known = self._known[-_REMEMBERED:]
        return told

    def _remembered(self, words: tuple[str, ...], place: Array, look: Array) -> Array | None:
        for asked, where, seen, row in reversed(self._known):
            if asked == words and _overlap(where, place) > _SAME_SHARE and np.abs(seen - look).max() < 25.0:
                return row
        return None

    def _asked(
        self, image: Image, boxes: Boxes, which: Sequence[int], words: tuple[str, ...]
    ) -> Array | None:
        content: list[dict[str, Any]] = [
            {"type": "text", "text": _PROMPT.format(labels=json.dumps([*words, "none"]))}
        ]
        content += [{"type": "image_url", "image_url": {"url": _crop_url(image, boxes, k)}} for k in which]
        try:
            answers = _answers(self._ask(content), len(which), words)
        except (SilentModelError, ValueError) as wrong:
            self._failures += 1
            self.trouble = f"what things are called is not told by a model: {wrong}"
            return None
        self._failures, self.trouble = 0, ""
        return answers


def _answers(text: str, count: int, words: tuple[str, ...]) -> Array:
    """The scores in an answer, which is untrusted.

    Raises:
        ValueError: It is something else.
    """
    told = np.zeros((count, len(words)))
    try:
        answers = json.loads(text[text.index("{") : text.rindex("}") + 1])["answers"]
        for answer in answers:
            number, label, score = int(answer["picture"]), str(answer["label"]), float(answer["score"])
            if 1 <= number <= count and label in words and 0.0 <= score <= 1.0:
                told[number - 1, words.index(label)] = score
    except (KeyError, TypeError, ValueError, OverflowError, RecursionError) as wrong:
        raise ValueError(f"its answer has another form: {type(wrong).__name__}") from None
    return told


def _crop_url(image: Image, boxes: Boxes, k: int) -> str:
    left, top, right, bottom = boxes.places[k].tolist()
    rows, columns = image.shape[:2]
    crop = image[
        max(top - _ROOM_PX, 0) : min(bottom + _ROOM_PX, rows),
        max(left - _ROOM_PX, 0) : min(right + _ROOM_PX, columns),
    ]
    times = _LONG_PX / max(crop.shape[:2])
    size = max(round(crop.shape[1] * times), 1), max(round(crop.shape[0] * times), 1)
    _, packed = cv2.imencode(".png", cv2.resize(crop, size, interpolation=cv2.INTER_CUBIC)[..., ::-1])
    return "data:image/png;base64," + base64.b64encode(packed.tobytes()).decode("ascii")


def _mean(image: Image, boxes: Boxes, k: int) -> Array:
    left, top, right, bottom = boxes.places[k].tolist()
    mask = boxes.mask(k)
    crop = image[top:bottom, left:right]
    return np.asarray((crop[mask] if mask.any() else crop.reshape(-1, 3)).mean(axis=0), dtype=np.float64)


def _overlap(a: Array, b: Array) -> float:
    wide, tall = min(a[2], b[2]) - max(a[0], b[0]), min(a[3], b[3]) - max(a[1], b[1])
    shared = max(float(wide), 0.0) * max(float(tall), 0.0)
    both = (a[2] - a[0]) * (a[3] - a[1]) + (b[2] - b[0]) * (b[3] - b[1]) - shared
    return shared / max(float(both), 1e-9)
