"""What the environment says: where data go, and how the terminal wants to be written to."""

from __future__ import annotations

import os
import sys
from pathlib import Path

APPLICATION = "humanoid-executive"


def data_directory() -> Path:
    """Where this user's recorded runs and crash reports go, by the platform's custom."""
    home = Path.home()
    if sys.platform == "win32":
        return Path(os.environ.get("LOCALAPPDATA") or home / "AppData" / "Local") / APPLICATION
    if sys.platform == "darwin":
        return home / "Library" / "Application Support" / APPLICATION
    return Path(os.environ.get("XDG_DATA_HOME") or home / ".local" / "share") / APPLICATION


def runs_directory() -> Path:
    """Where runs are recorded unless ``--record`` says otherwise."""
    return data_directory() / "runs"


def crashes_directory() -> Path:
    """Where crash reports go."""
    return data_directory() / "crashes"


def leave_opengl_to_the_renderer() -> None:
    """Forget ``MUJOCO_GL``: importing MuJoCo fails when it names a library that is missing, while
    pictures are drawn with whichever library is there.
    """
    os.environ.pop("MUJOCO_GL", None)
