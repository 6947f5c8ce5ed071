"""What an evaluation cannot write is found out before its episodes."""

import pytest

from tools.evaluate import __main__ as evaluate


@pytest.mark.parametrize("option", ["--json", "--failed"])
def test_an_output_that_cannot_be_written_is_refused_beforehand(option, tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(evaluate, "run_each", None)
    (tmp_path / "file").write_text("")

    assert evaluate.main(["pick", "--episodes", "1", option, str(tmp_path / "file" / "x")]) == 2
    assert str(tmp_path / "file") in capsys.readouterr().err.replace("\n", "")
