"""Sentences with a correction drawn at random mean what was meant, or are refused; never anything else."""

import random

from executive.understanding.command_parser import parse

KINDS = ("cup", "bottle", "box", "ball", "bowl", "plate")
PLACES = ("table", "shelf", "counter", "sofa")
ROOMS = ("kitchen", "bedroom", "office")
PEOPLE = ("Ana", "Ben", "Tom", "Julia")
RELATIONS = ("next to", "behind", "in front of")
MARKERS = (
    *(
        ", no wait, ",
        ", no, ",
        " no wait ",
        ", sorry, ",
        ", I mean ",
        ", actually ",
        ", or rather ",
        " - no, ",
    ),
    *(", make that ", ", scratch that, ", ". No, ", ". Sorry, I meant "),
)


def thing(rng):
    return f"the {rng.choice(('', '', 'red ', 'blue ', 'big ', 'small red '))}{rng.choice(KINDS)}"


SLOTS = {
    "thing": thing,
    "place": lambda rng: f"the {rng.choice(PLACES)}",
    "room": lambda rng: f"the {rng.choice(ROOMS)}",
    "person": lambda rng: rng.choice(PEOPLE),
    "number": lambda rng: rng.choice(("two", "three", "four")),
    "side": lambda rng: rng.choice(("left", "right")),
    "relation": lambda rng: rng.choice(RELATIONS),
}
SENTENCES = (
    ("pick up", "thing"),
    ("take", "thing", "from", "place"),
    ("put", "thing", "on", "place"),
    ("bring", "person", "thing"),
    ("hand", "thing", "to", "person"),
    ("go to", "room", "and pick up", "thing"),
    ("move forward", "number", "meters"),
    ("turn", "side"),
    ("pick up", "thing", "with your", "side", "hand"),
    ("put", "thing", "relation", "thing"),
    ("take", "thing", "and put it on", "place"),
    ("wave to", "person"),
)


def corrected_sentence(rng):
    """A sentence with a correction of one of its slots, and the sentence that is meant."""
    said = rng.choice(SENTENCES)
    words = [SLOTS[one](rng) if one in SLOTS else one for one in said]
    place = rng.choice([index for index, one in enumerate(said) if one in SLOTS])
    anew = next(one for one in iter(lambda: SLOTS[said[place]](rng), None) if one != words[place])
    spoken = anew
    noun = words[place].split()[-1]
    if said[place] == "thing" and anew.count(" ") > 1 and rng.random() < 0.4:
        spoken = f"{anew.rpartition(' ')[0]} one"
        anew = f"{anew.rpartition(' ')[0]} {noun}"
    meant = " ".join([*words[:place], anew, *words[place + 1 :]])
    start, rest = " ".join(words[: place + 1]), " ".join(words[place + 1 :])
    marker = rng.choice(MARKERS)
    if rng.random() < 0.5:
        return f"{start} {rest}".strip() + marker + spoken, meant
    return f"{start}{marker}{spoken} {rest}".strip(), meant


def test_a_correction_means_the_sentence_that_was_meant_or_nothing():
    rng = random.Random(20261122)
    understood = 0

    for _ in range(250):
        said, meant = corrected_sentence(rng)
        tasks = parse(said).to_json()["tasks"]
        understood += bool(tasks)
        assert tasks in ([], parse(meant).to_json()["tasks"]), said

    assert understood > 150
