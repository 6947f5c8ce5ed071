"""Every list of words that tell what a clause may do has a name of its own: one would hide the other."""

import importlib.resources
import tomllib
from collections import Counter

from executive.language.motives.reason import LIST_FILES, words_of


def test_no_list_hides_another():
    folder = importlib.resources.files("executive.language.motives")
    lists = [tomllib.loads(folder.joinpath(f"{name}.toml").read_text("utf-8")) for name in LIST_FILES]
    names = Counter(name for each in lists for name in each)

    assert [name for name, count in names.items() if count > 1] == []
    assert all(words_of(name) for name in names)
