"""The doctor says where sentences go, and sends none."""

from executive.checks.machine import diagnose
from executive.config import CONFIG_VARIABLE


def models(monkeypatch, tmp_path, text):
    """What the doctor finds of models, with a file of settings."""
    file = tmp_path / "config.toml"
    file.write_text(text)
    monkeypatch.setenv(CONFIG_VARIABLE, str(file))
    return [one for one in diagnose() if one.name.startswith("model ") or one.name == "models"]


def test_a_model_is_told_with_its_address(monkeypatch, tmp_path):
    [found] = models(monkeypatch, tmp_path, '[models.house]\nurl = "http://127.0.0.1:1/v1"\nmodel = "m"\n')

    assert found.ok
    assert not found.needed
    assert "http://127.0.0.1:1/v1" in found.detail


def test_a_key_that_is_not_there_is_told(monkeypatch, tmp_path):
    monkeypatch.delenv("A_KEY", raising=False)
    table = '[models.house]\nurl = "http://127.0.0.1:1/v1"\nmodel = "m"\nkey_env = "A_KEY"\n'

    [found] = models(monkeypatch, tmp_path, table)

    assert not found.ok
    assert "A_KEY" in found.fix


def test_a_table_that_is_wrong_is_told(monkeypatch, tmp_path):
    [found] = models(monkeypatch, tmp_path, '[models.house]\nmodel = "m"\n')

    assert not found.ok
    assert "models.house.url: is missing" in found.detail


def test_where_pictures_go_is_told(monkeypatch, tmp_path):
    table = '[models.house]\nurl = "http://127.0.0.1:1/v1"\nmodel = "m"\nsees = true\n'

    [found] = models(monkeypatch, tmp_path, table)

    assert "pictures of things that a camera sees go there" in found.detail
