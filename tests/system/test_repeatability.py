"""The same seed gives the same events, to the last byte, in another process too."""

import json
import os
import subprocess
import sys

import pytest

LOOK = "look at the red cup"
"""Seen with errors that the seed draws."""


def digest(folder, seed, hashes, sentence="pick up the red cup on the table"):
    report = folder / f"{seed}-{hashes}.json"
    command = [sys.executable, "-m", "executive", "run", sentence, "--seed", str(seed)]
    done = subprocess.run(
        [*command, "--report", str(report), "--record", str(folder / report.stem), "--plain"],
        env={**os.environ, "OMP_NUM_THREADS": "1", "PYTHONHASHSEED": str(hashes)},
        capture_output=True,
        text=True,
        timeout=240,
        check=False,
    )
    assert done.returncode in (0, 1), done.stderr[-2000:]
    return json.loads(report.read_text("utf-8"))["events_sha256"]


@pytest.mark.requirement("U1")
def test_the_same_seed_in_two_processes_gives_the_same_digest(tmp_path):
    assert digest(tmp_path, 4, 0) == digest(tmp_path, 4, 1)


def test_another_seed_gives_another_digest(tmp_path):
    assert digest(tmp_path, 4, 0, LOOK) != digest(tmp_path, 5, 0, LOOK)
