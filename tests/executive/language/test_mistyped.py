"""A sentence with mistyped words is refused, with the sentence that was meant; other languages stay."""

import time

import pytest

from executive.understanding.command_parser import parse


@pytest.mark.requirement("L5")
@pytest.mark.parametrize(
    ("said", "meant", "nearest"),
    [
        ("Can you giv me the ball?", "give", "Can you give me the ball?"),
        ("Can you giv me the bal?", "give", "Can you give me the ball?"),
        ("pik up teh red cup", "pick", "pick up the red cup"),
        ("Pick up the red cpu from the tabel.", "cup", "Pick up the red cup from the table."),
        ("Please lok at the botle.", "look", "Please look at the bottle."),
        ("wlak to the kichten", "walk", "walk to the kitchen"),
        ("trun letf", "turn", "turn left"),
        ("pik up teh red cpu from teh tabel adn put it on teh shlef", "pick", None),
        ("open the refridgerater", "refrigerator", "open the refrigerator"),
        ("pick up th red cup", "the", "pick up the red cup"),
        ("go ot the kitchen", "to", "go to the kitchen"),
        ("take the cup form the table", "from", "take the cup from the table"),
        ("put teh appel in the bowel", "the", "put the apple in the bowl"),
    ],
)
def test_the_sentence_that_was_meant_is_offered(said, meant, nearest):
    parsed = parse(said)

    assert parsed.commands == ()
    assert f"did you mean {meant!r}?" in parsed.refusal.message
    assert parse(parsed.refusal.nearest).commands
    assert nearest is None or parsed.refusal.nearest == nearest


@pytest.mark.parametrize(("said", "meant"), [("put teh bal", "the"), ("I wnat the red cup", "want")])
def test_what_would_be_asked_is_not_offered_as_a_sentence(said, meant):
    refusal = parse(said).refusal

    assert f"did you mean {meant!r}?" in refusal.message
    assert parse(refusal.nearest).commands


@pytest.mark.requirement("L5")
@pytest.mark.parametrize(
    "said",
    [
        "Nimm die rote Tasse",
        "Bring mir die Tasse",
        "Stell die Flasche auf den Tisch",
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
