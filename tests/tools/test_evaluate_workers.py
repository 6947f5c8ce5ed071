"""Episodes run beside each other, are kept as they end, and one that dies takes no other with it."""

import contextlib
import json
import os
import random
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from executive.errors import UserError
from tools.evaluate.harness.execution import Execution, run_each
from tools.evaluate.harness.journal import set_aside
from tools.evaluate.orders import EpisodeOrder
from tools.evaluate.phases import PhaseWatch
from tools.evaluate.records import EpisodeRecord, dead_episode
from trees.events import NodeChanged

ROOT = Path(__file__).parents[2]
ORDERS = [EpisodeOrder(seed) for seed in range(6)]


def fine(order: EpisodeOrder) -> EpisodeRecord:
    numbers = {"a": 1, "b": True, "c": "x", "d": 0.5}
    return EpisodeRecord(order.seed, "done", True, detail=os.environ["OMP_NUM_THREADS"], numbers=numbers)


def dies_at_two(order: EpisodeOrder) -> EpisodeRecord:
    if order.seed == 2:
        os._exit(1)
    return fine(order)


def dies_once(order: EpisodeOrder) -> EpisodeRecord:
    been = Path(os.environ["BEEN_THERE"]) / str(order.seed)
    if not been.exists():
        been.touch()
        os.kill(os.getpid(), signal.SIGKILL)
    return fine(order)


def never(order: EpisodeOrder) -> EpisodeRecord:
    raise AssertionError(f"episode {order.seed} is run again")


def by_seed(records):
    return {record.seed: record for record in records}


def lines(file):
    return [json.loads(line) for line in file.read_text().splitlines()]


@pytest.mark.parametrize("jobs", [1, 2])
def test_every_episode_gives_one_record_on_one_core(jobs):
    found = list(run_each(ORDERS, Execution("x", jobs), fine, dead_episode))

    assert sorted(record.seed for record in found) == list(range(6))
    assert {record.detail for record in found} == {"1"}


def test_an_episode_of_which_processes_die_costs_itself_and_the_rest_goes_on(tmp_path):
    kept = tmp_path / "kept.jsonl"
    found = by_seed(run_each(ORDERS, Execution("x", 1, kept), dies_at_two, dead_episode))

    assert set(found) == set(range(6))
    assert [seed for seed, record in found.items() if record.outcome == "error"] == [2]
    assert {line["order"]["seed"]: line["cost"]["deaths"] for line in lines(kept)}[2] == 5


def test_an_episode_whose_process_is_killed_is_run_again(tmp_path, monkeypatch):
    monkeypatch.setenv("BEEN_THERE", str(tmp_path))
    found = by_seed(run_each(ORDERS, Execution("x", 2), dies_once, dead_episode))

    assert found == by_seed(run_each(ORDERS, Execution("x", 2), fine, dead_episode))


def test_what_an_episode_raises_ends_everything_and_tells_it():
    with pytest.raises(AssertionError, match="run again"):
        list(run_each(ORDERS, Execution("x", 2), never, dead_episode))


def test_records_that_are_kept_are_read_as_they_were_and_not_run_again(tmp_path):
    kept = Execution("x", 2, tmp_path / "deep" / "kept.jsonl")
    first = by_seed(run_each(ORDERS, kept, fine, dead_episode))

    assert by_seed(run_each(ORDERS, kept, never, dead_episode)) == first


def test_half_a_line_that_a_kill_has_left_is_run_again(tmp_path):
    kept = Execution("x", 1, tmp_path / "kept.jsonl")
    first = by_seed(run_each(ORDERS, kept, fine, dead_episode))
    kept.journal.write_bytes(kept.journal.read_bytes()[:-200])

    assert by_seed(run_each(ORDERS, kept, fine, dead_episode)) == first
    assert by_seed(run_each(ORDERS, kept, never, dead_episode)) == first


def test_a_journal_of_something_else_is_refused_by_its_line(tmp_path):
    file = tmp_path / "kept.jsonl"
    list(run_each(ORDERS[:1], Execution("pick", 1, file), fine, dead_episode))

    with pytest.raises(UserError, match="episode 1: of suite pick; expected one of place"):
        list(run_each(ORDERS, Execution("place", 1, file), fine, dead_episode))


def test_what_was_kept_before_gets_a_name_of_its_own(tmp_path):
    file = tmp_path / "kept.jsonl"
    for text in ("a", "b"):
        file.write_text(text)
        set_aside(file)

    assert (tmp_path / "kept.1.jsonl").read_text() == "a"
    assert (tmp_path / "kept.2.jsonl").read_text() == "b"
    assert set_aside(file) is None


def test_an_evaluation_that_is_told_to_end_keeps_its_records_and_goes_on_with_them(tmp_path):
    command = [sys.executable, "-m", "tools.evaluate", "say", "--episodes", "3", "--jobs", "1"]
    command += ["--failed", str(tmp_path), "--json", str(tmp_path / "say.json")]
    kept = tmp_path / "say-seed0-x3.jsonl"
    with subprocess.Popen(command, cwd=ROOT, stderr=subprocess.PIPE, text=True) as process:
        while not (kept.exists() and kept.read_text().count("\n") >= 1):
            assert process.poll() is None
            time.sleep(0.05)
        process.send_signal(signal.SIGTERM)
        told = process.stderr.read()
    assert process.returncode == 4
    assert "--resume goes on after what" in told
    before = lines(kept)

    subprocess.run([*command, "--resume"], cwd=ROOT, capture_output=True, check=True)

    assert lines(kept)[: len(before)] == before
    assert sorted(line["order"]["seed"] for line in lines(kept)) == list(range(3))
    assert json.loads((tmp_path / "say.json").read_text())["episodes"] == 3


def test_a_phase_is_remembered_by_its_first_beginning():
    watch = PhaseWatch()
    for t_s, where, status in (
        (1.0, "pick/attempt/stream reach", "running"),
        (2.0, "pick/attempt/stream reach", "success"),
        (5.0, "pick/attempt/stream reach", "running"),
    ):
        watch.take(NodeChanged(t_s, where, status, ""))

    assert watch.began_s("stream reach") == 1.0
    assert watch.began_s("stream lift") is None


KILLED = """
import sys
from pathlib import Path
from tests.tools.test_evaluate_workers import slowly
from tools.evaluate.harness.execution import Execution, run_each
from tools.evaluate.orders import EpisodeOrder
from tools.evaluate.records import dead_episode

if __name__ == "__main__":
    orders = [EpisodeOrder(seed) for seed in range(200)]
    for _ in run_each(orders, Execution("x", 2, Path(sys.argv[1])), slowly, dead_episode):
        pass
"""


def slowly(order: EpisodeOrder) -> EpisodeRecord:
    time.sleep(0.01)
    return fine(order)


@pytest.mark.requirement("U7")
@pytest.mark.minutes
@pytest.mark.timeout(600)
def test_a_run_that_is_killed_again_and_again_loses_no_episode_and_doubles_none(tmp_path):
    program, kept = tmp_path / "program.py", tmp_path / "kept.jsonl"
    program.write_text(KILLED)
    command = [sys.executable, str(program), str(kept)]
    rng = random.Random(0)
    for _ in range(2):
        there = len(whole_lines(kept))
        with subprocess.Popen(command, cwd=ROOT, env={**os.environ, "PYTHONPATH": str(ROOT)}) as process:
            while process.poll() is None and len(whole_lines(kept)) == there:
                time.sleep(0.002)
            time.sleep(rng.uniform(0.0, 0.1))  # in the middle of whatever it is at
            process.kill()

    subprocess.run(command, cwd=ROOT, env={**os.environ, "PYTHONPATH": str(ROOT)}, check=True)

    assert sorted(line["order"]["seed"] for line in whole_lines(kept)) == list(range(200))


def whole_lines(file):
    """What can be read of a journal that is being written."""
    found = []
    for line in file.read_text().splitlines() if file.exists() else ():
        with contextlib.suppress(json.JSONDecodeError):
            found.append(json.loads(line))
    return found
