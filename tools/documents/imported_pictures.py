"""Pictures of imported scenes for the documentation, drawn from what the scenes' makers distribute.

    python -m tools.documents.imported_pictures FOLDER

``FOLDER`` has the scenes as ``tests/peers/programs/export_scenes.py`` writes them. No mesh of theirs enters
this repository; whose they are is told in ``docs/reference/assets.md``.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

PICTURES = Path(__file__).parents[2] / "docs" / "pictures"
SHOWN = {
    "kitchen_scene3": ("talos", "pick up the moka pot"),
    "libero_goal": ("talos", "pick up the wine bottle"),
    "robosuite_pickplace": ("panda", "pick up the milk"),
}
"""Of each scene who stands in it and what that is told to do before the picture is taken."""


def picture_of(scene: str) -> str:
    """Name of a scene's picture."""
    return f"imported_{scene}.png"


def draw(exported: Path, to: Path) -> list[str]:
    """Import each scene on the way and draw the end of what is done there.

    Args:
        exported: Folder with the scenes of others, MJCF.
        to: Folder of the pictures.

    Returns:
        What went wrong, a line each.
    """
    wrong = []
    for scene, (robot, sentence) in SHOWN.items():
        command = [sys.executable, "-m", "executive", "run", sentence, "--robot", robot]
        command += ["--scene", str(exported / f"{scene}.xml"), "--snapshot", str(to / picture_of(scene))]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode:
            last = (done.stdout + done.stderr).strip().rpartition("\n")[2]
            wrong.append(f"{scene}: {last}")
    return wrong


def main(arguments: Sequence[str] | None = None) -> int:
    """Draw all of them into the documentation; 1 when one could not be drawn."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("exported", type=Path, metavar="FOLDER", help="with the scenes of others")
    wrong = draw(parser.parse_args(arguments).exported, PICTURES)
    print("\n".join(wrong or [f"{len(SHOWN)} pictures"]))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
