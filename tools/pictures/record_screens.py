"""``python -m tools.pictures.record_screens``: what the terminal showed in real runs, for
`tools.pictures.draw_screens`.

Two runs of the default robot: a pick whose cup is pushed away once, so that a failure and a second attempt
are seen, stopped from the keyboard on its second way; and a pick of "the cup" where there are two.
"""

from __future__ import annotations

import io
import json
import re
import tempfile
from dataclasses import asdict
from pathlib import Path

from rich.console import Console

from executive.dialogue.attendant import Stoppable
from executive.dialogue.clarification import OpenQuestion
from executive.runs.run import perform
from executive.runs.run_request import RunRequest
from executive.screens.display import LiveDisplay
from executive.screens.screen import ScreenState
from executive.scripts.task_script import script_for
from robots.scenes.planned_fault import PlannedFault
from trees.snapshot import NodeSnapshot

RECORDED = Path(__file__).with_name("screens.json")

_PUSHED = PlannedFault("object_moved", 7.0, "red cup", (0.03, 0.06))
_ON_THE_WAY = re.compile(r"\b[4-9]\d%")


def _is_reaching(node: NodeSnapshot) -> bool:
    """Whether the arm is about half-way to the cup."""
    if node.name == "stream reach" and node.status == "running":
        return _ON_THE_WAY.search(node.message) is not None
    return any(map(_is_reaching, node.children))


class _Recorder:
    """Keeps what is shown on the second way to the cup, stops the robot then, and when something is asked."""

    def __init__(self, display: LiveDisplay) -> None:
        self.states: dict[str, ScreenState] = {}
        self._display = display

    def begin(self, _session: Stoppable) -> None:
        """Nothing to prepare."""

    def answer(self, question: OpenQuestion) -> str | None:
        """Keep the question as it is shown, and leave it open."""
        self._display.ask(question)
        self.states["asking"] = self._display.state
        return None

    def attend(self, session: Stoppable) -> None:
        """Keep the screen once the arm is under way again; stop, and keep what is shown a moment later."""
        self._display.draw()
        state = self._display.state
        if "stopped" in self.states or state.tree is None:
            return
        if "running" in self.states:
            if state.alarmed:
                self.states["stopped"] = state
        elif state.failure and _is_reaching(state.tree.root):
            self.states["running"] = state
            session.emergency_stop("stopped from the keyboard")


def _recorded(text: str, scene: str, seed: int, *faults: PlannedFault) -> dict[str, ScreenState]:
    display = LiveDisplay(Console(file=io.StringIO()), f"talos in {scene}, seed {seed}", keys=True)
    recorder = _Recorder(display)
    with tempfile.TemporaryDirectory() as folder:
        request = RunRequest(
            input=text,
            statements=script_for(text).statements,
            robot="talos",
            scene=scene,
            seed=seed,
            record=Path(folder),
            faults=faults,
        )
        print(perform(request, display, recorder).line)
    return recorder.states


def main() -> None:
    """Run, and write what was shown."""
    states = {
        **_recorded("pick up the red cup on the table", "tabletop", 7, _PUSHED),
        **_recorded("pick up the cup", "clutter", 7),
    }
    text = json.dumps({name: asdict(states[name]) for name in ("running", "asking", "stopped")})
    RECORDED.write_text(text + "\n", "utf-8")


if __name__ == "__main__":
    main()
