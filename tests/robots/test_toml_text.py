import tomllib

import pytest
from hypothesis import given
from hypothesis import strategies as st

from robots.toml_text import MOST_PARTS, TomlTextError, read_toml


def refused(text):
    with pytest.raises(TomlTextError) as caught:
        read_toml(text)
    return str(caught.value)


def test_a_byte_order_mark_is_passed_over():
    assert read_toml("\ufeffa = 1") == {"a": 1}


def test_a_byte_order_mark_elsewhere_is_no_toml():
    refused("a = 1\n\ufeffb = 2")


@pytest.mark.parametrize(
    "text",
    ["{} = 1", "[{}]", "[[{}]]", "x = {{ {} = 1 }}", "x = {{ y = 1, {} = 1 }}", "[t]\n  {} = 1"],
)
@pytest.mark.parametrize("part", ["a", '"a"', "'a'", "a ", "a\t"])
def test_a_key_of_very_many_parts_is_refused_before_it_is_read(text, part):
    assert f"more than {MOST_PARTS} parts" in refused(text.format(".".join([part] * 100_000)))


def test_a_key_of_the_most_parts_is_read():
    assert read_toml(".".join("a" * MOST_PARTS) + " = 1")


@pytest.mark.parametrize("quotes", ['"', "'", '"""'])
def test_a_sentence_of_many_short_ones_is_no_key(quotes):
    sentence = "No. " * 100

    assert read_toml(f"say = {quotes}{sentence}{quotes}") == {"say": sentence}


def test_brackets_without_end_are_refused():
    assert "nested too deeply" in refused("x = " + "[" * 100_000)


@given(st.text(max_size=100))
def test_any_text_is_read_as_pythons_reader_does_or_refused(text):
    try:
        expected = tomllib.loads(text.removeprefix("\ufeff"))
    except tomllib.TOMLDecodeError:
        refused(text)
    else:
        assert read_toml(text) == expected
