"""Drawings of an evaluation of perception: how confidence and truth go together, and the worst pictures."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw

from robots.scenes.light import LightKind
from tools.evaluate.perception.judge import Bench, PictureRecord
from tools.evaluate.perception.summary import PerceptionSummary

_SIZE, _EDGE = 360, 40
_COLUMNS = 2
_INK, _GREY, _BLUE = (30, 30, 30), (200, 200, 200), (40, 90, 200)


def draw_calibration(summary: PerceptionSummary, path: Path) -> None:
    """Share that was right over confidence, one dot a bin, as large as the bin is full."""
    image = Image.new("RGB", (_SIZE + 2 * _EDGE, _SIZE + 2 * _EDGE), "white")
    pen = ImageDraw.Draw(image)

    def at(x: float, y: float) -> tuple[float, float]:
        return _EDGE + x * _SIZE, _EDGE + (1.0 - y) * _SIZE

    for tick in np.linspace(0.0, 1.0, 6):
        pen.line([at(tick, 0.0), at(tick, 1.0)], fill=_GREY)
        pen.line([at(0.0, tick), at(1.0, tick)], fill=_GREY)
        pen.text((at(tick, 0.0)[0] - 8, at(0.0, 0.0)[1] + 4), f"{tick:.1f}", fill=_INK)
        pen.text((6, at(0.0, tick)[1] - 6), f"{tick:.1f}", fill=_INK)
    pen.line([at(0.0, 0.0), at(1.0, 1.0)], fill=_INK)
    bins = summary.calibration()
    most = max((count for _, _, count in bins), default=1)
    for sure, right, count in bins:
        x, y = at(sure, right)
        radius = 3.0 + 9.0 * (count / most) ** 0.5
        pen.ellipse([x - radius, y - radius, x + radius, y + radius], fill=_BLUE)
    title = f"right over confidence; expected calibration error {summary.calibration_error():.3f}"
    pen.text((_EDGE, 12), title, fill=_INK)
    image.save(path)


def draw_worst(records: Sequence[PictureRecord], path: Path, light: LightKind | None = None) -> None:
    """The pictures of some seeds, with what was told and what was missed."""
    bench = Bench()
    tiles = []
    for record in records:
        if record.broken:
            continue
        bench.judge(record.seed, light)
        tiles.append(_tile(bench, record))
    if not tiles:
        return
    blank = np.zeros_like(tiles[0])
    tiles += [blank] * (-len(tiles) % _COLUMNS)
    rows = [np.hstack(tiles[i : i + _COLUMNS]) for i in range(0, len(tiles), _COLUMNS)]
    Image.fromarray(np.vstack(rows)).save(path)


def _tile(bench: Bench, record: PictureRecord) -> NDArray[np.uint8]:
    if bench.last is None:
        raise RuntimeError("no picture was judged")
    picture, seen, _ = bench.last
    image = picture.color.copy()
    for thing in seen.things:
        u0, v0, u1, v1 = thing.box
        cv2.rectangle(image, (u0, v0), (u1, v1), (255, 255, 255), 1)
        words = f"{thing.color} {thing.call.kind} {thing.confidence:.2f}"
        _write(image, words, (u0, max(v0 - 4, 10)))
    wrong = []
    for one in record.things:
        if not one.name:
            wrong.append(f"not there: {one.told_color} {one.told_kind}")
        elif not one.found and one.visible >= 0.4:
            wrong.append(f"missed: {one.name}")
        elif one.found and one.visible >= 0.4:
            told = f"{one.told_color} {one.told_kind}"
            if (one.color, one.kind) != (one.told_color, one.told_kind) or one.position_m > 0.012:
                wrong.append(f"{one.name}: {told}, off {1e3 * one.position_m:.0f} mm")
    for k, line in enumerate([f"seed {record.seed}, {record.kind}, {record.light}", *wrong]):
        _write(image, line, (6, 16 + 15 * k))
    return image


def _write(image: NDArray[np.uint8], words: str, at: tuple[int, int]) -> None:
    for color, width in (((0, 0, 0), 3), ((255, 255, 255), 1)):
        cv2.putText(image, words, at, cv2.FONT_HERSHEY_SIMPLEX, 0.42, color, width, cv2.LINE_AA)
