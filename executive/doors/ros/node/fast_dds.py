"""What is particular to Fast DDS, the middleware of ROS 2 by default.

Its writers ask for acknowledgements every 3 s, unless a profile has them ask oftener. Its ids of endpoints
tell the process: two bytes of the vendor, two of the machine, the lower half of the process's number.
"""

from __future__ import annotations

import os
from collections.abc import Iterable
from pathlib import Path

PARTICIPANT = 12
"""So many bytes of an endpoint's id are its participant's."""
_VENDOR, _MACHINE, _PROCESS = b"\x01\x0f", slice(2, 4), slice(4, 6)
_VARIABLES = {2: "FASTRTPS_DEFAULT_PROFILES_FILE", 3: "FASTDDS_DEFAULT_PROFILES_FILE"}
"""What tells each version of Fast DDS its profiles."""


def ask_often(version: int) -> bool:
    """Have the writers of this process ask for acknowledgements four times a second.

    To be called before rclpy begins. False, and nothing is changed, where the user has profiles of their own.

    Args:
        version: Of Fast DDS: 2 or 3, whose profiles differ in the name of an element.
    """
    if any(os.environ.get(name) for name in _VARIABLES.values()):
        return False
    os.environ[_VARIABLES[version]] = os.fspath(Path(__file__).parent / f"fast_dds_{version}.xml")
    return True


class Processes:
    """Which endpoints belonged to processes of this machine that have ended.

    Only a process that was there when its endpoint was first seen can be known to have ended: that of a
    container has other numbers there than here. Of processes whose numbers end alike all have to have ended.

    Args:
        proc: Where the processes are listed.
    """

    def __init__(self, proc: Path = Path("/proc")) -> None:
        self._proc = proc
        self._found: dict[bytes, frozenset[int]] = {}

    def see(self, endpoints: Iterable[bytes], own: bytes) -> None:
        """Take in which endpoints there are.

        Args:
            endpoints: Their ids; others are forgotten.
            own: The id of one of this process.
        """
        before = self._found
        self._found = {one: before[one] if one in before else self._processes(one, own) for one in endpoints}

    def has_ended(self, endpoint: bytes) -> bool:
        """Whether the process of an endpoint is known to have ended."""
        found = self._found.get(endpoint)
        return bool(found) and not any(self._lives(number) for number in found or ())

    def _processes(self, endpoint: bytes, own: bytes) -> frozenset[int]:
        here = endpoint[:2] == own[:2] == _VENDOR and endpoint[_MACHINE] == own[_MACHINE]
        if not here or not self._proc.is_dir():
            return frozenset()
        half = int.from_bytes(endpoint[_PROCESS], "little")
        numbers = (int(one.name) for one in self._proc.iterdir() if one.name.isdecimal())
        return frozenset(one for one in numbers if one & 0xFFFF == half and self._lives(one))

    def _lives(self, number: int) -> bool:
        """Whether a process is there, and is not one that has ended and that nobody has asked about yet."""
        try:
            told = (self._proc / str(number) / "stat").read_text("utf-8", "replace")
        except OSError:
            return False
        return told.rpartition(")")[2].split()[:1] not in (["Z"], ["X"])
