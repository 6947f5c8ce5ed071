"""What would harm although every word of it is known: a fork in a toaster, a knife for a baby.

It is told from the tasks, where "it" is known to be the fork. Only what is plainly dangerous is listed; a
robot that refuses what is merely unwise would be of no use.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from executive.language.phrases import Trouble
from executive.meaning import Command
from trees.tasks import HandOverTask, ObjectDescription, ObjectOf, PlaceTask, PutInTask

_CHILDREN = frozenset({"child", "baby", "boy", "girl", "toddler", "infant", "newborn"})
_CRIBS = frozenset(
    {"crib", "cot", "cradle", "bassinet", "carrycot", "carry cot", "moses basket", "playpen", "play pen"}
    | {"pram", "pushchair", "buggy", "stroller", "high chair", "baby bed"}
)
_SHARP = frozenset(
    {"knife", "scissors", "screwdriver", "drill", "axe", "razor", "needle", "cleaver", "scalpel", "blade"}
    | {"saw", "hacksaw", "chainsaw", "hatchet", "machete", "sickle", "scythe", "chisel", "dagger", "skewer"}
    | {"cutter", "syringe", "lancet", "shears", "secateurs", "pruners", "nail", "pin", "tack", "thumbtack"}
)
_FIRE = frozenset(
    {"lighter", "matches", "match", "blowtorch", "torch lighter", "cigarette", "cigar", "firelighter"}
)
_POISON = frozenset(
    {"bleach", "detergent", "cleaner", "disinfectant", "antifreeze", "insecticide", "pesticide", "weedkiller"}
    | {"ammonia", "acetone", "methanol", "turpentine", "spirits", "petrol", "gasoline", "diesel", "kerosene"}
    | {
        "paraffin",
        "acid",
        "descaler",
        "remover",
        "polish",
        "morphine",
        "insulin",
        "syringe",
        "vodka",
        "whisky",
    }
    | {
        "whiskey",
        "gin",
        "rum",
        "tequila",
        "brandy",
        "cognac",
        "killer",
        "pellets",
        "thinner",
        "capsule",
        "pod",
    }
)
_HARMLESS = frozenset(
    {
        "coffee pod",
        "coffee capsule",
        "fish oil capsule",
        "vacuum cleaner",
        "robot vacuum cleaner",
        "lens cleaner",
    }
    | {"pipe cleaner", "screen cleaner", "carpet cleaner", "lint remover", "staple remover", "rolling pin"}
    | {"bowling pin", "clothes pin", "hair pin", "cookie cutter", "pastry cutter", "biscuit cutter"}
)
"""What only ends like something that is listed."""
_MEDICINE = frozenset({"pill", "pills", "medicine", "medication", "painkiller", "painkillers", "tablets"})
_EXPLODES = frozenset(
    {
        "lighter",
        "matches",
        "petrol",
        "gasoline",
        "diesel",
        "kerosene",
        "spray",
        "hairspray",
        "battery",
        "fuel",
    }
    | {"aerosol", "firelighter", "can of paint", "gas bottle", "gas canister", "gas cylinder", "propane tank"}
    | {"gas can", "spray can", "spray paint", "lighter fluid", "power bank", "powerbank", "oxygen bottle"}
)
_ELECTRIC = frozenset(
    {"phone", "laptop", "tablet", "computer", "charger", "cable", "cord", "lead", "lamp", "heater", "dryer"}
    | {
        "radio",
        "toaster",
        "monitor",
        "keyboard",
        "camera",
        "watch",
        "headphones",
        "speaker",
        "strip",
        "drill",
    }
    | {
        "remote",
        "router",
        "printer",
        "television",
        "blender",
        "mixer",
        "fan",
        "iron",
        "shaver",
        "straightener",
    }
)
_METAL = frozenset(
    {"fork", "knife", "spoon", "teaspoon", "tablespoon", "cutlery", "silverware", "foil", "tinfoil", "can"}
    | {"pan", "skillet", "wok", "whisk", "ladle", "tongs", "scissors", "tweezers", "key", "keys", "coin"}
    | {
        "nail",
        "screw",
        "bolt",
        "nut",
        "wire",
        "needle",
        "skewer",
        "screwdriver",
        "wrench",
        "spanner",
        "pliers",
    }
    | {"hammer", "paperclip", "hairpin", "ring", "necklace", "bracelet", "chain", "wool pad", "clip", "pin"}
)
_BURNS = frozenset(
    {"paper", "newspaper", "magazine", "letter", "envelope", "towel", "cloth", "rag", "napkin", "tissue"}
    | {"blanket", "pillow", "cushion", "shirt", "sock", "clothes", "book", "cardboard", "straw"}
)
_BAKED_IN = frozenset({"baking paper", "parchment paper"})
_HEATS = frozenset(
    {"oven", "microwave", "toaster", "toaster oven", "mini oven", "pizza oven", "bread oven", "combi oven"}
    | {"air fryer", "fryer", "deep fryer", "grill", "sandwich toaster", "waffle iron", "stove", "fireplace"}
    | {"wood stove", "wood burner", "log burner", "gas stove", "cooktop", "stovetop", "hearth", "radiator"}
)
_OPEN_FIRE = frozenset({"fireplace", "wood stove", "wood burner", "log burner", "hearth", "radiator"})
"""Where paper and wood may lie, or a cloth dries."""

_SPARKS = frozenset({"microwave", "toaster", "sandwich toaster"})
_WATER = frozenset(
    {"bathtub", "bath tub", "bath", "tub", "shower", "fish tank", "aquarium", "fishbowl", "pool"}
)
_SWALLOWED = frozenset(
    {
        "drink",
        "coffee",
        "tea",
        "soup",
        "juice",
        "milk",
        "water",
        "beer",
        "wine",
        "food",
        "salad",
        "cake",
        "stew",
    }
    | {"smoothie", "lemonade", "baby bottle", "sippy cup", "cup", "glass", "teapot", "coffee pot", "dog bowl"}
    | {"cat bowl", "food bowl", "pet bowl", "water bowl", "lunch box", "lunch", "kettle"}
)


def harm_in(commands: Sequence[Command]) -> Trouble | None:
    """Why a robot must not do this, or None."""
    for command in commands:
        if not isinstance(command, HandOverTask | PutInTask | PlaceTask):
            continue
        given = _described(command.object, commands)
        thing = given.kind if isinstance(given, ObjectDescription) else None
        if thing is None:
            continue
        if isinstance(command, HandOverTask):
            person = _kind(command.to, commands)
            if person in _CHILDREN and _hurts_a_child(thing, person):
                return Trouble(f"the {thing} could harm a {person}; it is not handed over", thing)
            continue
        place = command.on if isinstance(command, PlaceTask) and command.on is not None else command.to
        where = _kind(place, commands)
        into = isinstance(command, PutInTask)
        if where is not None and _is_dangerous(thing, given.material, where, into=into):
            relation = "in" if into else "on"
            return Trouble(
                f"the {thing} {relation} the {where} could harm; this robot does not do that", thing
            )
    return None


def _described(thing: Any, commands: Sequence[Command]) -> Any:
    """The description behind "it", which may stand for what "it" stood for before."""
    for _ in commands:
        if not isinstance(thing, ObjectOf) or not 0 <= thing.task < len(commands):
            break
        thing = getattr(commands[thing.task], "object", None)
    return thing


def _kind(place: Any, commands: Sequence[Command]) -> str | None:
    described = _described(place, commands)
    if isinstance(described, ObjectDescription):
        return None if described.kind is None else described.kind.lower()
    return described.lower() if isinstance(described, str) else None


def _is(kind: str, listed: frozenset[str]) -> bool:
    """Whether a kind is listed, or made of one: a "bread knife" is a knife."""
    return kind in listed or kind.rpartition(" ")[2] in listed


def _poisons(thing: str) -> bool:
    bottle = thing.removesuffix(" bottle").removesuffix(" box").removesuffix(" can")
    return thing not in _HARMLESS and (_is(thing, _POISON) or _is(bottle, _POISON))


def _hurts_a_child(thing: str, person: str) -> bool:
    if thing.startswith("toy ") or thing in _HARMLESS:
        return False
    small = person in ("baby", "toddler", "infant", "newborn")
    return _is(thing, _SHARP) or _is(thing, _FIRE) or _poisons(thing) or (small and _is(thing, _MEDICINE))


def _is_dangerous(thing: str, material: str | None, where: str, *, into: bool) -> bool:
    if thing.startswith("toy ") and where not in _HEATS:
        return False
    if where in _CRIBS:
        return _is(thing, _SHARP) or _is(thing, _FIRE) or _poisons(thing)
    if where in _HEATS and (_is(thing, _EXPLODES) or _is(thing, _ELECTRIC)):
        return True
    if where in _HEATS - _OPEN_FIRE and into and _is(thing, _BURNS) and thing not in _BAKED_IN:
        return True
    if where in _SPARKS and into and (material == "metal" or (material is None and _is(thing, _METAL))):
        return True
    if where in _WATER and into and _is(thing, _ELECTRIC):
        return True
    return into and where in _SWALLOWED and _poisons(thing)
