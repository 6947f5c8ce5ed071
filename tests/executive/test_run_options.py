"""Options of ``run`` about questions and models, through the command line."""

import json
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import jsonschema
import pytest
from typer.testing import CliRunner

from executive.cli import app as cli

SCHEMA = json.loads((Path(__file__).parents[2] / "docs" / "reference" / "report.schema.json").read_text())


@pytest.fixture
def executive(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    return lambda *arguments, **options: CliRunner().invoke(cli.app, list(arguments), **options)


def steps(*pairs):
    return json.dumps([{"command": text, "confidence": confidence} for text, confidence in pairs])


@pytest.mark.requirement("L8")
def test_partial_leaves_out_what_is_doubtful_and_reports_it(executive, tmp_path):
    report = tmp_path / "report.json"
    text = steps(("go home", 0.95), ("pick up the red cup", 0.5))

    result = executive("run", text, "--policy", "partial", "--quiet", "--report", str(report))

    document = json.loads(report.read_text())
    jsonschema.validate(document, SCHEMA)
    assert result.exit_code == 0
    assert "left out: 'pick up the red cup' (confidence 0.50 is below 0.80)" in result.stdout
    assert [task["provenance"]["step"] for task in document["tasks"]] == [0]
    assert document["left_out"][0]["provenance"]["confidence"] == 0.5


@pytest.mark.requirement("L8")
@pytest.mark.parametrize(
    ("answer", "code", "says"), [(None, 3, "confidence 0.50"), ("no\n", 2, "withdrawn"), ("yes\n", 0, "done")]
)
def test_low_confidence_is_asked_about(executive, answer, code, says):
    result = executive("run", steps(("go home", 0.5)), "--quiet", input=answer)

    assert result.exit_code == code
    assert says in result.stdout


@pytest.mark.requirement("L7", "F2")
@pytest.mark.parametrize("text", ['{"command": "go home", "confidence": NaN}', "[", '{"a":' * 3000])
def test_invalid_output_of_a_model_moves_nothing(executive, text):
    result = executive("run", text, "--quiet")

    assert result.exit_code == 2
    assert "the model's output is not valid" in result.stdout


@pytest.mark.requirement("U1")
def test_a_script_writes_a_junit_report(executive, tmp_path):
    script, junit = tmp_path / "tidy.toml", tmp_path / "junit.xml"
    script.write_text('[[task]]\nsay = "go home"\n[[task]]\nsay = "fly to the moon"\nexpect = "refused"\n')

    result = executive("run", str(script), "--quiet", "--junit", str(junit))

    suite = ElementTree.parse(junit).getroot().find("testsuite")
    assert result.exit_code == 0
    assert (suite.attrib["tests"], suite.attrib["failures"]) == ("2", "0")
