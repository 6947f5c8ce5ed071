"""What a terminal would show, as a picture beside the frames of a film."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFont

from executive.screens.display import Display, KeptScreen
from executive.screens.rows import Style, line_row, rule_row, tree_rows
from executive.session.events import Event

if TYPE_CHECKING:
    from trees.build import TaskTree

WIDTH_PX = 480
_FONT, _FONT_PX, _ROW_PX, _EDGE_PX = "DejaVuSansMono.ttf", 12, 16, 8
_LOG_ROWS = 6
_PAPER, _INK = (24, 26, 30), (222, 224, 228)
_COLORS: dict[Style, tuple[int, int, int]] = {
    "dim": (132, 138, 148),
    "ok": (92, 190, 112),
    "running": (98, 176, 240),
    "bad": (240, 104, 96),
    "ask": (240, 200, 90),
    "alarm": (240, 104, 96),
}


class FilmPanel(KeptScreen):
    """A display that draws what another one shows; satisfies ``executive.screens.display.Display``.

    Args:
        display: Shows the run as well.
        place: Robot, scene and seed, in a few words.
    """

    def __init__(self, display: Display, place: str) -> None:
        super().__init__(place)
        self._display = display
        self._tree: TaskTree | None = None
        self._font: ImageFont.FreeTypeFont | ImageFont.ImageFont
        try:
            self._font = ImageFont.truetype(_FONT, _FONT_PX)
            self._unicode = True
        except OSError:  # the font that Pillow brings has no glyphs of trees
            self._font, self._unicode = ImageFont.load_default(_FONT_PX), False

    def event(self, event: Event) -> None:
        """Take what it changes, and show it."""
        super().event(event)
        self._display.event(event)

    def tick(self, tree: TaskTree) -> None:
        """Know the tree under way, and show it."""
        self._teller.learn(tree)
        self._tree = tree
        self._display.tick(tree)

    def note(self, line: str) -> None:
        """Show a line that stays."""
        self._display.note(line)

    def close(self) -> None:
        """Nothing of the panel's own to leave."""
        self._display.close()

    def picture(self, height_px: int, t_s: float) -> NDArray[np.uint8]:
        """The panel at a time, shape (height, ``WIDTH_PX``, 3)."""
        if self._tree is not None:
            self.state = replace(self.state, tree=self._tree.snapshot(t_s))
        state, unicode = replace(self.state, t_s=t_s), self._unicode
        columns = int((WIDTH_PX - 2 * _EDGE_PX) / self._font.getlength("m"))
        rows = (height_px - 2 * _EDGE_PX) // _ROW_PX
        head = [line_row(state.task or "waits for a task", "bold", columns, unicode)]
        head.append(line_row(f"{state.place}  {t_s:.1f} s", "dim", columns, unicode))
        foot = [rule_row(columns, unicode)]
        foot += [line_row(line, "dim", columns, unicode) for line in state.log[-_LOG_ROWS:]]
        if state.failure:
            foot.append(line_row(state.failure, "bad", columns, unicode))
        if state.alarmed:
            foot.append(line_row(state.safety, "alarm", columns, unicode))
        tree = tree_rows(state.tree, columns, max(rows - len(head) - len(foot) - 1, 1), unicode)
        image = Image.new("RGB", (WIDTH_PX, height_px), _PAPER)
        draw = ImageDraw.Draw(image)
        for number, row in enumerate([*head, rule_row(columns, unicode), *tree, *foot][:rows]):
            x = float(_EDGE_PX)
            for cell in row:
                y = _EDGE_PX + number * _ROW_PX
                draw.text((x, y), cell.text, _COLORS.get(cell.style, _INK), self._font)
                x += self._font.getlength(cell.text)
        return np.asarray(image)
