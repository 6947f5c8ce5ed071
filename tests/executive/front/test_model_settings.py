"""The tables [models.NAME] of a settings file."""

import pytest

from executive.front.model_settings import ModelSettings, ModelSettingsError, model_called, model_settings


@pytest.fixture
def settings(tmp_path):
    def write(text):
        file = tmp_path / "config.toml"
        file.write_text(text)
        return [file]

    return write


def test_what_is_left_out_is_the_usual(settings):
    files = settings('[models.house]\nurl = "http://127.0.0.1:8080/v1/"\nmodel = "m"\n')

    assert model_called("house", files) == ModelSettings("house", "http://127.0.0.1:8080/v1", "m")


def test_of_two_tables_of_one_name_the_later_one_counts(settings, tmp_path):
    first = settings('[models.house]\nurl = "http://a/v1"\nmodel = "m"\n')
    other = tmp_path / "other.toml"
    other.write_text('[models.house]\nurl = "http://b/v1"\nmodel = "m"\nattempts = 0\n')

    assert model_settings([*first, other])["house"].url == "http://b/v1"


@pytest.mark.parametrize(
    ("lines", "told"),
    [
        ('model = "m"', "models.house.url: is missing"),
        ('url = "ftp://x"\nmodel = "m"', "models.house.url: must be an address"),
        ('url = "http://x/v1?key=1"\nmodel = "m"', "without a key"),
        ('url = "http://x"\nmodel = "m"\nkey_env = "sk-123 45"', "the key itself does not belong here"),
        ('url = "http://x"\nmodel = "m"\nwhen = "sometimes"', "models.house.when"),
        ('url = "http://x"\nmodel = "m"\ntimeout_s = 0.0', "above 0"),
        ('url = "http://x"\nmodel = "m"\nattempts = 99', "from 0 to 10"),
        ('url = "http://x"\nmodel = "m"\nkey = "sk"', "unknown key"),
    ],
)
def test_what_is_wrong_is_told_with_its_key(settings, lines, told):
    with pytest.raises(ModelSettingsError, match=r"config\.toml") as caught:
        model_settings(settings(f"[models.house]\n{lines}\n"))

    assert told in str(caught.value)


def test_an_unknown_name_is_told_with_the_nearest(settings):
    files = settings('[models.house]\nurl = "http://x/v1"\nmodel = "m"\n')

    with pytest.raises(ModelSettingsError, match="no model 'hous'; the nearest is 'house'"):
        model_called("hous", files)
