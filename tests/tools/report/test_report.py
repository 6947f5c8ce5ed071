"""What docs/measured holds is what the report makes of its records; a killed report goes on."""

import json
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from tools.evaluate.__main__ import SUITES
from tools.report.__main__ import FOLDER, main
from tools.report.carrying_out import NotMeasuredError, Settings, carry_out, known_records
from tools.report.machine import ROOT, Place
from tools.report.pages import pages
from tools.report.pictures import pictures
from tools.report.published import RECORDS, publish
from tools.report.quotes import BEGIN, END, figures_beside, with_quotes
from tools.report.record import FORMAT, MeasuredRecord
from tools.report.runs import NOT_REPORTED, RUNS, Run, chosen

MEASURED = list(known_records(FOLDER / RECORDS).values())
PLACE = Place(version="1", sources="abc", machine="m", libraries="l")
MOST_BYTES = 2_000_000


def record(name="pick", good=3):
    return MeasuredRecord(
        format=FORMAT, name=name, suite=name, kind="episodes", command="c", quick=False, place=PLACE,
        seeds=(0, 3), judged=4, good=good, counts={"false_success": 0, "falls": 0}, failures={},
        failed_seeds=[], bars=[], figures={}, cost={},
    )  # fmt: skip


@pytest.mark.requirement("U7")
@pytest.mark.parametrize("name", pages(MEASURED))
def test_a_page_is_what_the_report_makes_of_the_records(name):
    told = "run python -m tools.report --pages"
    assert (FOLDER / name).read_text("utf-8") == pages(MEASURED)[name], told


def test_the_folder_holds_no_page_and_no_picture_beside_them():
    assert {file.name for file in FOLDER.glob("*.md")} == set(pages(MEASURED))
    assert {file.name for file in (FOLDER / "pictures").iterdir()} == set(pictures(MEASURED))


def test_pages_do_not_tell_which_run_came_first(tmp_path):
    publish(MEASURED[::-1], tmp_path)

    for name, text in pages(MEASURED).items():
        assert (tmp_path / name).read_text("utf-8") == text, name


def test_records_take_little_room_and_each_is_of_a_run_that_there_is():
    files = list((FOLDER / RECORDS).iterdir())

    assert sum(file.stat().st_size for file in files) <= MOST_BYTES
    assert {file.stem for file in files} <= {run.name for run in RUNS}


@pytest.mark.requirement("U7")
def test_every_suite_is_in_the_report():
    assert set(SUITES) - {run.suite for run in RUNS} == NOT_REPORTED


def test_runs_have_names_of_their_own():
    assert len({run.name for run in RUNS}) == len(RUNS)


def test_a_suite_stands_for_its_runs_and_what_there_is_not_is_refused():
    assert {run.name for run in chosen(["fault"])} >= {"fault-joint_stuck", "fault-gyro_bias"}
    with pytest.raises(ValueError, match="no run is called 'pik'"):
        chosen(["pik"])


def test_what_the_readme_quotes_is_what_was_measured():
    text = (ROOT / "README.md").read_text("utf-8")

    assert with_quotes(text, MEASURED) == text, "run python -m tools.report --pages"
    assert figures_beside(text) == []


def test_a_quote_is_made_anew_and_the_text_around_it_stays():
    text = f"# A\n\n{BEGIN}\nan old table\n{END}\n\nb\n"

    made = with_quotes(text, [record()])

    assert made.startswith(f"# A\n\n{BEGIN}\n| suite |")
    assert "| [pick](docs/measured/pick.md) | 4 | 3 (30–95 %) | 0 | 0 |" in made
    assert made.endswith(f"{END}\n\nb\n")
    assert with_quotes(made, [record()]) == made


@pytest.mark.parametrize("text", ["it held 19 of 20 cups", "97 % of all", "97.5% good"])
def test_a_result_that_nothing_holds_is_found(text):
    assert figures_beside(text)
    assert not figures_beside(f"{BEGIN}\n{text}\n{END}\n200 random episodes\n")


def test_publishing_makes_a_folder_whole(tmp_path):
    for name in ("old.md", "records/old.json", "pictures/old.svg"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text("{}")

    publish([record(), record("place")], tmp_path)

    assert sorted(str(file.relative_to(tmp_path)) for file in tmp_path.rglob("*") if file.is_file()) == [
        "index.md", "pick.md", "pictures/good.svg", "place.md", "records/pick.json", "records/place.json",
    ]  # fmt: skip
    assert publish([record(), record("place")], tmp_path) == []


def test_a_run_that_cannot_be_carried_out_says_why(tmp_path):
    with pytest.raises(NotMeasuredError, match=r"exit code 2"):
        carry_out(Run("x", "pick", ("--scene", "nowhere")), Settings(tmp_path, PLACE))


def test_a_wrong_name_is_refused_before_anything_is_run(tmp_path, capsys):
    assert main(["--only", "pik", "--work", str(tmp_path / "work")]) == 2
    assert not (tmp_path / "work").exists()


@pytest.mark.requirement("U7")
def test_a_report_that_is_killed_goes_on_where_it_was(tmp_path):
    command = [sys.executable, "-m", "tools.report", "--only", "say", "wait", "--episodes", "1"]
    command += ["--work", str(tmp_path / "work"), "--into", str(tmp_path / "measured")]
    with subprocess.Popen(command, cwd=ROOT, stderr=subprocess.PIPE, text=True) as process:
        while not lines(tmp_path, "say"):
            assert process.poll() is None
            time.sleep(0.05)
        process.send_signal(signal.SIGTERM)
        told = process.stderr.read()
    assert process.returncode == 4
    assert "the same command goes on" in told
    before = lines(tmp_path, "say")

    subprocess.run(command, cwd=ROOT, capture_output=True, check=True)

    assert lines(tmp_path, "say") == before
    found = known_records(tmp_path / "measured" / "records")
    assert {name: one.judged for name, one in found.items()} == {"say": 1, "wait": 1}
    assert found["say"].cost["processor_s"] > 0.0


def lines(folder: Path, name):
    files = list((folder / "work").glob(f"*/{name}.jsonl"))
    return [json.loads(line) for file in files for line in file.read_text().splitlines()]
