"""The same seed gives the same events, to the last byte, in another process too."""

import json
import os
import subprocess
import sys

import pytest
from typer.testing import CliRunner

from executive.cli.app import app

LOOK = "look at the red cup"
"""Seen with errors that the seed draws."""


def options(folder, seed, name):
    report = folder / f"{name}.json"
    return report, ["--seed", seed, "--report", report, "--record", folder / name, "--plain"]


def digest(folder, seed, hashes):
    report, chosen = options(folder, seed, f"{seed}-{hashes}")
    command = [sys.executable, "-m", "executive", "run", "pick up the red cup on the table"]
    done = subprocess.run(
        [*command, *map(str, chosen)],
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


def digest_here(folder, seed):
    report, chosen = options(folder, seed, str(seed))
    done = CliRunner().invoke(app, ["run", LOOK, *map(str, chosen)])
    assert done.exit_code in (0, 1), done.output
    return json.loads(report.read_text("utf-8"))["events_sha256"]


def test_another_seed_gives_another_digest(tmp_path):
    assert digest_here(tmp_path, 4) != digest_here(tmp_path, 5)
