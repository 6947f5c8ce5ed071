"""Task scripts are read strictly: file, key and reason."""

import pytest

from executive.errors import ScriptError
from executive.scripts.task_script import is_script, load_script


@pytest.fixture
def script(tmp_path):
    def write(text):
        path = tmp_path / "tidy.toml"
        path.write_text(text)
        return path

    return write


TWO_TASKS = """
seed = 3
scene = "clutter"
[[task]]
say = "go home"
[[task]]
say = "stop"
expect = "done"
"""


def test_a_script_is_an_ordered_list_of_sentences(script):
    loaded = load_script(script(TWO_TASKS))

    assert [one.parsed.text for one in loaded.statements] == ["go home", "stop"]
    assert (loaded.seed, loaded.scene, loaded.robot) == (3, "clutter", None)


def test_a_scene_file_is_found_beside_the_script(script, tmp_path):
    loaded = load_script(script('scene = "kitchen.toml"\n[[task]]\nsay = "go home"\n'))

    assert loaded.scene == str(tmp_path / "kitchen.toml")


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("", "task"),
        ("task = 3", "task"),
        ("[[task]]\nsay = 3", "task[0].say"),
        ('[[task]]\nsai = "go home"', "nearest is 'say'"),
        ('sed = 1\n[[task]]\nsay = "go home"', "nearest is 'seed'"),
        ('[[task]]\nsay = "go home"\non_failure = "panic"', "stop, continue, retry"),
        ('[[task]]\nsay = "go home"\nexpect = "luck"', "task[0].expect"),
        ('[[task]]\nsay = "go home"\ntimeout_s = -1', "task[0].timeout_s"),
        ('[[task]]\nsay = "go home"\ntimeout_s = nan', "task[0].timeout_s"),
        ('seed = true\n[[task]]\nsay = "go home"', "seed"),
        ("[[task", "not TOML"),
        ("x = " + "[" * 100_000, "tidy.toml"),
        (".".join("a" * 100_000) + " = 1", "more than 32 parts"),
        ('[[task]]\nsay = "go home"\n' * 1001, "has 1001 tasks; a script holds at most 1000"),
    ],
)
def test_a_broken_script_is_refused_with_the_key_and_the_reason(script, text, reason):
    with pytest.raises(ScriptError) as refused:
        load_script(script(text))

    assert reason in str(refused.value)


def test_a_missing_script_is_refused(tmp_path):
    with pytest.raises(ScriptError, match="No such file"):
        load_script(tmp_path / "none.toml")


@pytest.mark.parametrize(
    ("argument", "script_wanted"),
    [("tidy.toml", True), ("pick up the red cup", False), ("x" * 100_000, False), ("\0", False)],
)
def test_what_ends_in_toml_or_is_a_file_is_a_script(argument, script_wanted):
    assert is_script(argument) is script_wanted
