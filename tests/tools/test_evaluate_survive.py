"""What was killed is compared with what was left alone; only the machine's quickness may differ."""

import json
import os
import subprocess
import sys

import pytest

from tools.evaluate.__main__ import main
from tools.evaluate.survival.processes import below, kill
from tools.evaluate.survival.same_records import survived


def line(seed, deaths=0, **record):
    return {
        "format": "humanoid-executive/episode/1", "suite": "wave", "version": "1", "order": {"seed": seed},
        "good": True, "record": {"seed": seed, "outcome": "done", "wall_s": 1.0, "numbers": {}, **record},
        "cost": {"wall_s": 1.0, "processor_s": 1.0, "memory_mb": 1.0, "process": "h:1", "deaths": deaths},
    }  # fmt: skip


def journal(folder, name, *lines):
    file = folder / f"{name}.jsonl"
    file.write_text("".join(f"{json.dumps(one)}\n" for one in lines))
    return file


@pytest.fixture
def alone(tmp_path):
    return journal(tmp_path, "alone", *map(line, range(4)))


def test_the_same_records_in_another_order_and_at_another_pace_are_whole(alone, tmp_path):
    others = [line(seed, deaths=1, wall_s=9.0, numbers={"slowest_plan_ms": 7.0}) for seed in (3, 1, 0, 2)]
    records = journal(tmp_path, "alone", *(line(seed, numbers={"slowest_plan_ms": 1.0}) for seed in range(4)))

    found = survived(records, journal(tmp_path, "killed", *others))

    assert found.whole
    assert (found.recorded, found.died) == (4, 4)


@pytest.mark.parametrize(
    ("lines", "wrong"),
    [
        ([line(0), line(1), line(2)], "lost"),
        ([line(0), line(1), line(2), line(3), line(3)], "doubled"),
        ([line(0), line(1), line(2), line(3, outcome="failed")], "other"),
        ([line(0), line(1), line(2), line(3, numbers={"lift_m": 0.1})], "other"),
        ([line(0), line(1), line(2), line(3), line(4)], "other"),
    ],
)
def test_what_is_lost_doubled_or_other_is_told_by_its_order(alone, tmp_path, lines, wrong):
    found = survived(alone, journal(tmp_path, "killed", *lines))

    assert not found.whole
    assert [len(getattr(found, name)) for name in ("lost", "doubled", "other")].count(1) == 1
    assert len(getattr(found, wrong)) == 1


def begun(name):
    return [pid for pid, told in below(os.getpid()).items() if told.endswith(name)]


def test_what_a_process_has_begun_is_found_with_what_that_has_begun():
    code = "import subprocess, sys; subprocess.run([sys.executable, '-c', 'input()', 'the inner one'])"
    with subprocess.Popen([sys.executable, "-c", code, "the outer one"], stdin=subprocess.PIPE) as process:
        while not (inner := begun("the inner one")):
            assert process.poll() is None
        assert begun("the outer one") == [process.pid]

        assert kill(inner[0])
        process.wait()
    assert inner[0] not in below(os.getpid())
    assert not kill(inner[0])


def test_an_evaluation_that_cannot_be_begun_is_told_with_its_reason(capsys):
    assert main(["survive", "evaluation", "--suite", "nothing", "--episodes", "2", "--kills", "0"]) == 2
    told = " ".join(capsys.readouterr().err.split())
    assert "exit code 2 of" in told
    assert "'gpsr'" in told
