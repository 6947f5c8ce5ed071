"""``python -m tools.draw_screens``: pictures of the terminal for the docs, and the snapshots of its tests."""

from __future__ import annotations

import io
from dataclasses import replace
from pathlib import Path

from rich.console import Console
from rich.text import Text

from executive.clarification import OpenQuestion
from executive.outputs.display import drawing
from executive.outputs.screen import ScreenState, screen, text_of
from trees.snapshot import NodeKind, NodeSnapshot, NodeStatus, TreeSnapshot

ROOT = Path(__file__).parents[1]
PICTURES, SNAPSHOTS = ROOT / "docs" / "pictures", ROOT / "tests" / "executive" / "outputs" / "screens"
SIZES = ((80, 24), (160, 50))


def _node(
    name: str, kind: NodeKind, status: NodeStatus, message: str = "", *children: NodeSnapshot
) -> NodeSnapshot:
    return NodeSnapshot(name, kind, status, message, children)


def _leaf(name: str, status: NodeStatus = "idle", message: str = "") -> NodeSnapshot:
    return NodeSnapshot(name, "leaf", status, message)


_SEARCHED = _node(
    "search", "selector", "success", "",
    _node("look ahead", "sequence", "success", "",
          _leaf("look", "success", "looking ahead"),
          _leaf("detect", "success", "red cup at 0.52, +0.20, 0.95 m")),
    _leaf("look near"),
)  # fmt: skip
_PICKING = _node(
    "pick", "sequence", "running", "",
    _SEARCHED,
    _node("attempts", "selector", "running", "attempt 2 of 4",
          _node("plan", "sequence", "success", "",
                _leaf("plan pick", "success", "left hand, side 30 deg"),
                _leaf("check reach", "success", "2.10 s, nearest 21 mm"),
                _leaf("check approach", "success", "0.82 s, nearest 14 mm")),
          _node("reach", "sequence", "running", "",
                _leaf("open gripper", "success", "left hand 96 mm open"),
                _leaf("stream reach", "running", "42 %")),
          _leaf("confirm target"),
          _leaf("stream approach"),
          _node("grasp", "sequence", "idle", "",
                _leaf("close gripper"), _leaf("verify hold"), _leaf("attach")),
          _node("lift", "sequence", "idle", "",
                _leaf("check trajectory"), _leaf("stream lift"), _leaf("look"), _leaf("verify lift"))),
    _node("give up", "sequence", "idle", "", _leaf("put back"), _leaf("release"), _leaf("go home")),
)  # fmt: skip
_LOG = (
    "[   0.20 s] accepted: pick red cup from the table",
    "[   0.20 s] EXECUTING: pick/search/look ahead/look",
    "[   1.22 s] EXECUTING: pick/search/look ahead/detect",
    "[   1.52 s] EXECUTING: pick/plan/plan pick",
    "[   1.62 s] failed: no grasp: 12 in collision (considered 64) [INFEASIBLE at pick/plan/plan pick]",
    "[   2.92 s] EXECUTING: pick/plan/plan pick",
    "[   3.02 s] EXECUTING: pick/plan/check reach",
    "[   3.22 s] EXECUTING: pick/reach/stream reach",
)

RUNNING = ScreenState(
    place="talos in tabletop, seed 7",
    t_s=4.06,
    task="pick up the red cup on the table",
    tree=TreeSnapshot(4.06, 193, _PICKING),
    failure="no grasp: 12 in collision (considered 64) [INFEASIBLE at pick/plan/plan pick]",
    motion="stream reach",
    log=_LOG,
    keys=True,
)
ASKING = replace(
    RUNNING,
    t_s=1.96,
    task="pick up the cup",
    failure="",
    motion="",
    tree=TreeSnapshot(
        1.96,
        88,
        _node("pick", "sequence", "failure", "which cup? there are 3",
              _node("search", "selector", "failure", "",
                    _node("look ahead", "sequence", "failure", "",
                          _leaf("look", "success", "looking ahead"),
                          _leaf("detect", "failure", "looking for more than this cup")),
                    _node("look to the right", "sequence", "failure", "",
                          _leaf("look", "success", "looking to the right"),
                          _leaf("detect", "failure", "which cup? there are 3")))),
    ),
    question=OpenQuestion("which cup? there are 3", ("left red cup", "right red cup", "blue cup")),
    log=(*_LOG[:3], "[   1.96 s] question: which cup? there are 3: left red cup, right red cup or blue cup"),
)  # fmt: skip
STOPPED = replace(
    RUNNING,
    safety="EMERGENCY: stopped from the keyboard",
    alarmed=True,
    motion="",
    log=(*_LOG, "[   4.06 s] stop category 1: stopped from the keyboard"),
)

EXAMPLES = {"running": RUNNING, "asking": ASKING, "stopped": STOPPED}


def main() -> None:
    """Write pictures and snapshots."""
    SNAPSHOTS.mkdir(parents=True, exist_ok=True)
    for name, state in EXAMPLES.items():
        for width, height in SIZES:
            text = text_of(screen(state, width, height)) + "\n"
            (SNAPSHOTS / f"{name}_{width}x{height}.txt").write_text(text, "utf-8")
            for plain in (False, True):
                console = Console(
                    file=io.TextIOWrapper(io.BytesIO(), "utf-8"),
                    record=True,
                    width=width,
                    height=height,
                    force_terminal=True,
                    color_system="truecolor",
                )
                console.print(Text(text.rstrip("\n")) if plain else drawing(state, console))
                suffix = "_plain" if plain else ""
                picture = PICTURES / f"screen_{name}_{width}x{height}{suffix}.svg"
                picture.write_text(console.export_svg(title="executive run", unique_id=name), "utf-8")
    print(f"wrote {len(EXAMPLES)} screens in {len(SIZES)} sizes")


if __name__ == "__main__":
    main()
