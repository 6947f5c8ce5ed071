"""The same seed gives the same events, to the last byte, in another process too."""

import json
import os
import subprocess
import sys


def digest(folder, seed):
    report = folder / f"{seed}-{len(list(folder.iterdir()))}.json"
    call = "import sys; from executive.cli.app import main; sys.exit(main())"
    command = [sys.executable, "-c", call, "run", "pick up the red cup on the table", "--seed", str(seed)]
    done = subprocess.run(
        [*command, "--report", str(report), "--record", str(folder / report.stem), "--plain"],
        env={**os.environ, "OMP_NUM_THREADS": "1"},
        capture_output=True,
        text=True,
        timeout=240,
        check=False,
    )
    assert done.returncode in (0, 1), done.stderr[-2000:]
    return json.loads(report.read_text("utf-8"))["events_sha256"]


def test_the_same_seed_in_two_processes_gives_the_same_digest_and_another_seed_does_not(tmp_path):
    first, again, other = (digest(tmp_path, seed) for seed in (4, 4, 5))

    assert first == again
    assert first != other
