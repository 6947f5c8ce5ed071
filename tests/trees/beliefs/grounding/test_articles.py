import pytest

from trees.beliefs.grounding.articles import with_article


@pytest.mark.parametrize(("words", "told"), [("orange cup", "an orange cup"), ("red cup", "a red cup")])
def test_one_of_a_kind_has_its_article(words, told):
    assert with_article(words) == told
