"""What a robot behind the wire has to keep to, and that a bar that is not kept is told as such."""

import json

import pytest

from robots.models.description import load_robot
from robots.unitree.watch import Trouble
from tools.unitree import bars


@pytest.fixture(scope="module")
def g1():
    return load_robot("g1")


@pytest.mark.requirement("U8")
def test_a_wrong_mode_is_told_damped_and_followed_again_without_a_jump(g1):
    trial = bars.failing(g1, "wrong mode", "mode", 0.05, Trouble.WRONG_MODE, seed=1)

    assert trial.kept, trial.told


def test_another_trouble_than_what_came_is_not_kept(g1):
    trial = bars.failing(g1, "wrong mode", "mode", 0.05, Trouble.LATE, seed=1)

    assert not trial.kept
    assert "not kept: told, stop, damped" in trial.told


def test_one_that_is_not_kept_is_told_and_is_the_exit_code(monkeypatch, capsys, tmp_path):
    monkeypatch.setattr(bars, "failing", lambda _robot, name, *_: bars.Trial(name, name != "wrong mode", "x"))
    monkeypatch.setattr(bars, "standing", lambda *_: bars.Trial("stands", True, "x"))
    kept = tmp_path / "bars.json"

    code = bars.main(["--stand", "1", "--json", str(kept)])

    assert code == 1
    assert "NOT KEPT  wrong mode: x" in capsys.readouterr().out
    assert [trial["name"] for trial in json.loads(kept.read_text()) if not trial["kept"]] == ["wrong mode"]


def test_all_kept_is_exit_code_0(monkeypatch):
    monkeypatch.setattr(bars, "failing", lambda _robot, name, *_: bars.Trial(name, True, "x"))

    assert bars.main(["--stand", "0"]) == 0
