"""Environments of the peers: one venv each, with locked versions, below a cache folder.

They are apart from the product's environment because the peers need other versions of the same
libraries (Pinocchio 4 beside Pinocchio 3).
"""

from __future__ import annotations

import hashlib
import os
import subprocess
import sys
import venv
from dataclasses import dataclass
from pathlib import Path

from executive.config import APPLICATION

CACHE_VARIABLE = "HUMANOID_EXECUTIVE_BENCHMARK_CACHE"
_LOCKS = Path(__file__).parent
NAMES = ("roboplan", "ompl", "pyroboplan", "pink", "mink", "toppra")
ROS_NAMES = ("ros_jazzy", "ros_kilted")
"""Peers of the ROS door, for tests alone: rclpy of two distributions."""
MODEL_NAMES = ("smollm2",)
"""A small language model that travels in a package, with what serves it; for tests alone."""
ASSET_NAMES = ("libero", "foreign_scenes")
"""Objects and furniture of a benchmark; whole scenes of several, with what builds them. For tests alone."""


def default_cache() -> Path:
    """Where environments are kept: the variable if it is set, else the user's cache folder."""
    named = os.environ.get(CACHE_VARIABLE)
    if named:
        return Path(named)
    base = os.environ.get("XDG_CACHE_HOME")
    return (Path(base) if base else Path.home() / ".cache") / APPLICATION / "benchmark"


@dataclass(frozen=True, slots=True)
class PeerEnvironment:
    """One peer's environment.

    Attributes:
        name: One of ``NAMES``, ``ROS_NAMES``, ``MODEL_NAMES`` or ``ASSET_NAMES``.
        cache: Folder that holds all environments.
    """

    name: str
    cache: Path

    @property
    def lock(self) -> Path:
        """The file with its versions."""
        return _LOCKS / f"{self.name}.lock"

    @property
    def python(self) -> Path:
        """Its interpreter."""
        return self._folder / ("Scripts/python.exe" if sys.platform == "win32" else "bin/python")

    @property
    def version(self) -> str:
        """The locked version of the peer itself, the first line of its lock."""
        return self.lock.read_text("utf-8").split("\n", 1)[0]

    @property
    def is_ready(self) -> bool:
        """Whether it was made from the lock as it is now."""
        return self._stamp.is_file() and self._stamp.read_text("utf-8") == self._digest

    def make(self) -> None:
        """Make it anew unless it is ready.

        Raises:
            subprocess.CalledProcessError: A package could not be installed.
        """
        if self.is_ready:
            return
        venv.create(self._folder, clear=True, with_pip=True)
        install = [str(self.python), "-m", "pip", "install", "--quiet", "--no-deps", "-r", str(self.lock)]
        subprocess.run(install, check=True)
        self._stamp.write_text(self._digest, "utf-8")

    @property
    def _folder(self) -> Path:
        return self.cache / "environments" / self.name

    @property
    def _stamp(self) -> Path:
        return self._folder / "lock.sha256"

    @property
    def _digest(self) -> str:
        return hashlib.sha256(self.lock.read_bytes()).hexdigest()
