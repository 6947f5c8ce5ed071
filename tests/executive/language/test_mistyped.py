"""A sentence with mistyped words is refused, with the word that was meant; other languages stay."""

import time

import pytest

from executive.understanding.command_parser import parse


@pytest.mark.requirement("L5")
@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("Can you giv me the ball?", "give"),
        ("Can you giv me the bal?", "give"),
        ("Please lok at the botle.", "look"),
        ("wlak to the kichten", "walk"),
        ("put the botle on the table", "bottle"),
    ],
)
def test_the_word_that_was_meant_is_offered_and_nothing_is_done(said, meant):
    parsed = parse(said)

    assert parsed.commands == ()
    assert f"did you mean {meant!r}?" in parsed.refusal.message


@pytest.mark.requirement("L5")
@pytest.mark.parametrize(
    "said",
    [
        "Nimm die rote Tasse",
        "Bring mir die Tasse",
        "Mets la tasse sur la table",
        "Pon la taza en la mesa",
        "Apri la porta",
        "Pak de rode beker",
        "blarg fnord the wibble",
        "zorp the glim",
        "pick up la cup",
        "put el cup on the table",
        "move the cup closer to the bottle",
        "give me space",
        "go to Ana's room",
    ],
)
def test_what_is_not_mistyped_gets_no_suggestion(said):
    assert "did you mean" not in parse(said).refusal.message


def test_many_mistyped_words_take_no_long_time():
    said = (
        "pik up teh bule botle adn teh geren cpu form teh tabel, tehn put tehm on teh shlef in teh kichten "
        * 4
    )
    parse(said)
    start = time.process_time()

    assert parse(said[:480]).commands == ()

    assert time.process_time() - start < 0.2
