"""The branches of the tree that a person folds and unfolds by hand, on one page."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from executive.doors.view import panels
from executive.doors.view.shown_lines import lines_of

if TYPE_CHECKING:
    import viser

_NONE = "choose a branch"


class Folding:
    """What one page folds: a list of the branches in sight, of which the one that is chosen turns.

    Attributes:
        chosen: Of branches by their paths, whether they are to be open.
    """

    def __init__(self, gui: viser.GuiApi, turned: Callable[[], None] = lambda: None) -> None:
        """Add the list where the page is being made.

        Args:
            gui: Of the page.
            turned: Called when a branch was chosen, where nothing else shows the tree again.
        """
        self._turned = turned
        self.chosen: dict[str, bool] = {}
        self._open: dict[str, bool] = {}
        self._list = gui.add_dropdown("fold, unfold", (_NONE,), hint="A branch of the tree that is in sight")
        self._list.on_update(lambda _event: self._turn())

    def words(self, nodes: Sequence[Mapping[str, Any]], search: str, unfolded: bool) -> str:
        """The tree as HTML; the branches in sight can be chosen from now on.

        Args:
            nodes: From the root down, with their depths.
            search: Shows only nodes with these letters in name or message, and what they are in.
            unfolded: Whether all that nobody has folded is open.
        """
        found = lines_of(nodes, self.chosen, unfolded)
        branches = {line.path: line.open for line in found if line.branch}
        if branches.keys() != self._open.keys():
            self._list.options = (_NONE, *branches)
        self._open = branches
        return panels.found_panel(nodes, search) if search.strip() else panels.tree_panel(found)

    def _turn(self) -> None:
        path = self._list.value
        if path in self._open:
            self.chosen[path] = not self._open[path]
            self._list.value = _NONE  # type: ignore[misc]
            self._turned()
