"""Whether "him" or "her" may be said of somebody: of most names and of some nouns it is known."""

from __future__ import annotations

from executive.language.phrases.values import Nominal

_MEN = """
mr. grandpa man father grandfather son uncle nephew grandson husband boy brother waiter postman adam alan
albert alfred andrew anthony antonio arthur ben benjamin bernard bill bob brian bruno carl carlos charles
christian daniel dave david dennis diego dmitri donald edward eric felix frank fred george hans harry hassan
henry hugo ian ibrahim igor isaac ivan jack jacob jake james jason jim joe john jonas jorge jose joseph juan
karl kevin klaus larry leo leon lewis liam louis lucas luis luke lukas marco mario martin matt matthew max
michael miguel mike mohamed mohammed noah oliver omar oscar otto pablo patrick paul pedro peter philip
pierre raj ralph richard robert roger ron ryan samuel scott sebastian sergio simon stefan stephen steve
steven thomas tim tom tony victor vincent walter william yusuf emil elias gabriel julian nicolas theo
"""
_WOMEN = """
mrs. ms. miss grandma woman mother grandmother daughter aunt niece granddaughter wife waitress girl sister
ana anna anne alexandra alice amanda amelia amy angela anita barbara beatrice beth betty carla carmen carol
caroline catherine charlotte chloe christina christine claire clara claudia daniela deborah diana donna dora
dorothy elena eliza elizabeth ella ellen emily emma eva eve fatima fiona francesca gina grace greta hannah
helen ida ines ingrid irene isabel isabella jane janet jennifer jenny jessica joan judy julia julie karen
kate katherine kathy lara laura lea leila lena lily linda lisa louise lucia lucy margaret maria marie marina
martha mary maya mia michelle monica nadia nancy natalie nicole nina nora olivia pamela patricia paula priya
rachel rebecca rita rosa rosie ruth sally samantha sandra sara sarah sharon sofia sophia sophie stephanie
susan tanja tessa tina tracy vera veronica victoria wendy zoe
"""
_HE, _SHE = frozenset(_MEN.split()), frozenset(_WOMEN.split())


def may_be(pronoun: str, person: Nominal) -> bool:
    """Whether a pronoun, as it was said, may stand for somebody; of whom nothing is known it may."""
    return may_be_called(pronoun, person.kind or "")


def may_be_called(pronoun: str, name: str) -> bool:
    """Whether a pronoun, as it was said, may stand for somebody of a name."""
    known = name.lower().split()
    he, she = not _HE.isdisjoint(known), not _SHE.isdisjoint(known)
    return not ((pronoun == "him" and she and not he) or (pronoun == "her" and he and not she))
