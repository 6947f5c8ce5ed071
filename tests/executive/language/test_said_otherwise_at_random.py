"""Other wordings of plain commands, between random sentences: the same tasks, or none."""

import random

from executive.understanding.command_parser import parse

_THINGS = ("cup", "red bowl", "plate", "blue box", "green ball", "towel")
_PLACES = ("table", "shelf", "counter", "sofa")
_ROOMS = ("kitchen", "office", "hallway")
_WORDINGS = (
    ("give Ana her {a}", "give Ana's {a} to Ana"),
    ("bring Ben his {a} from the {p}", "bring Ben's {a} from the {p} to Ben"),
    ("take the {a} that Ana left on the {p}", "take the {a} from the {p}"),
    ("put the {a} on the {p} and the {b} too", "put the {a} on the {p} and put the {b} on the {p}"),
    ("bring the {a} to Ana and the {b} as well", "bring the {a} to Ana and the {b} to Ana"),
    ("the {a} on the {p}: put it on the {q}", "put the {a} from the {p} on the {q}"),
    ("the {a} on the {p}, bring it to Ana", "bring the {a} from the {p} to Ana"),
    ("in the {r}, take the {a}", "take the {a} from the {r}"),
    ("grab the {a} for me", "get the {a} for me"),
    ("get the {a} from the {p} onto the {q}", "put the {a} from the {p} onto the {q}"),
    ("take the {a} no the {b}", "take the {b}"),
    ("open the door to the {r}", "open the {r} door"),
    ("take from the {p} the {a}", "take the {a} from the {p}"),
    ("take the {a} with you to the {r}", "take the {a} to the {r}"),
    ("pick up the {a} with the left", "pick up the {a} with your left hand"),
    ("walk 1 m 20 cm forward", "walk 1.2 m forward"),
)
_BEFORE = (
    "",
    "go to the garden, then ",
    "wave to Mia and ",
    "open the drawer. ",
    "take the can, ",
    "look at Leo. ",
)
_AFTER = (
    *("", " and put it on the chair", ", then wave to her", ", then give it to him", " and bring it here"),
    *(
        ". Put the can there",
        ", then close it",
        " before you go home",
        ", no, the can",
        " after opening the fridge",
    ),
)


def test_other_words_for_a_command_mean_the_same_or_nothing():
    draw = random.Random(20261124)
    other = []
    for _ in range(700):
        (a, b), (p, q) = draw.sample(_THINGS, 2), draw.sample(_PLACES, 2)
        before, after, wordings = draw.choice(_BEFORE), draw.choice(_AFTER), draw.choice(_WORDINGS)
        room = draw.choice(_ROOMS)
        said, plain = (f"{before}{one.format(a=a, b=b, p=p, q=q, r=room)}{after}" for one in wordings)
        tasks, meant = (parse(one).to_json()["tasks"] for one in (said, plain))
        if tasks and meant and tasks != meant:
            other.append(said)

    assert other == []
