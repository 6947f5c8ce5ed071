"""What an evaluation cannot write or do is found out before its episodes."""

import pytest

from tools.evaluate import __main__ as evaluate


@pytest.mark.parametrize("option", ["--json", "--failed"])
def test_an_output_that_cannot_be_written_is_refused_beforehand(option, tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(evaluate, "run_each", None)
    (tmp_path / "file").write_text("")

    assert evaluate.main(["pick", "--episodes", "1", option, str(tmp_path / "file" / "x")]) == 2
    assert str(tmp_path / "file") in capsys.readouterr().err.replace("\n", "")


@pytest.mark.parametrize("option", [["--resume"], ["--ray"], ["--journal", "kept.jsonl"]])
def test_what_a_suite_in_a_row_cannot_do_is_refused(option, capsys):
    assert evaluate.main(["mcp", "--episodes", "1", *option]) == 2
    assert f"{option[0]}: the episodes of mcp are run in a row" in capsys.readouterr().err
