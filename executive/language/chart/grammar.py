"""The grammar's productions, shared by prefix, as lark reads them from ``grammar.lark``."""

from __future__ import annotations

import importlib.metadata
import importlib.resources
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from robots.kept import kept

CLOSING = "rest"
"""The rule for all clauses after the first, to the end of the sentence."""

Production = tuple[str, Sequence[str], str]
"""A rule's name, its parts, and the name of its meaning."""


@dataclass(slots=True)
class Node:
    """A place within a rule: where a word of a class or a part leads, and which meanings end here."""

    terminals: dict[str, Node] = field(default_factory=dict)
    rules: dict[str, Node] = field(default_factory=dict)
    functions: list[str] = field(default_factory=list)


@dataclass(frozen=True, slots=True)
class Rule:
    """One rule of the grammar, with the word classes that it can begin with and where its productions begin.

    The parts of one that ``repeats`` belong to the rule around it. Nothing follows one that ``closes``: what
    does not reach the end of the sentence is of no use.
    """

    name: str
    first: frozenset[str]
    root: Node
    repeats: bool
    closes: bool


def load_rules(cache: Path | None = None) -> dict[str, Rule]:
    """Read the grammar.

    Args:
        cache: A folder where lark's productions are kept from one process to the next: a command that
            only parses would spend most of its time on them. None keeps nothing.
    """
    text = grammar_text()
    if cache is None:
        return rules_of(_compiled(text))
    made_by = [importlib.metadata.version("lark").encode(), Path(__file__).read_bytes(), text.encode()]
    return rules_of(kept(cache, "grammar", made_by, lambda: list(_compiled(text))))


def grammar_text() -> str:
    """The grammar as it is written."""
    return importlib.resources.files("executive.language.chart").joinpath("grammar.lark").read_text("utf-8")


def terminals_of(text: str) -> set[str]:
    """The word classes that a grammar names."""
    return set(re.findall(r"\b[A-Z][A-Z_]+\b", re.sub(r"//.*", "", text)))


def _compiled(text: str) -> Iterable[Production]:
    from lark import Lark

    declared = "\n%declare " + " ".join(sorted(terminals_of(text))) + "\n"
    compiled = Lark(text + declared, parser="earley", lexer="dynamic", start=["start", "selection"])
    for rule in compiled.rules:
        yield (
            str(rule.origin.name),
            tuple(str(part.name) for part in rule.expansion),
            rule.alias or str(rule.origin.name),
        )


def rules_of(productions: Iterable[Production]) -> dict[str, Rule]:
    """Share the beginnings of each rule's productions; repetitions are turned to the right.

    Lark writes ``x*`` as ``y: x | y x``; a parser that goes from left to right needs ``y: x | x y``.
    """
    roots: dict[str, Node] = {}
    begins: dict[str, set[str]] = {}
    for name, parts, function in productions:
        if parts[0] == name:
            parts = [*parts[1:], name]
        begins.setdefault(name, set()).add(parts[0])
        node = roots.setdefault(name, Node())
        for part in parts:
            branch = node.terminals if part.isupper() else node.rules
            node = branch.setdefault(part, Node())
        if function not in node.functions:
            node.functions.append(function)
    rules = {}
    for name, root in roots.items():
        closes = name == CLOSING
        rules[name] = Rule(name, _first(name, begins), root, closes or name.startswith("__"), closes)
    return rules


def _first(name: str, begins: dict[str, set[str]]) -> frozenset[str]:
    seen: set[str] = set()
    pending = {name}
    while pending:
        pending |= begins.get(pending.pop(), set()) - seen
        seen |= pending
    return frozenset(part for part in seen if part.isupper())
