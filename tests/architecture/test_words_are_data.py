"""English words are data: what understands sentences compares no word of the input with a literal."""

from __future__ import annotations

import ast
import itertools
import re
from collections.abc import Iterator

import pytest
from source import Module, modules, parse

UNDERSTANDS = ("executive.language", "executive.vocabulary")
UNDERSTANDS_TOO = ("executive.references", "executive.understanding.command_parser")
# What holds words as somebody said them: attributes, and names of variables that nothing else is called by.
SAID = frozenset({"said", "text", "texts", "plain", "sentence"})
COMPARING = frozenset({"startswith", "endswith", "removeprefix", "removesuffix", "count", "index", "find"})
MATCHING = frozenset({"match", "fullmatch", "search", "finditer", "findall", "sub"})
LOOKING_UP = frozenset({"isdisjoint", "intersection", "issubset", "issuperset"})
WORD = re.compile(r"(?<![a-z\\])(?:[a-z]{2,}|[ai])(?![a-z])", re.IGNORECASE)
NO_WORDS_OF_A_PATTERN = re.compile(
    r"\\d\+\(\?:[a-z|]+\)|\\.|\[[^\]]*\]|\(\?(?:P<\w+>|P=\w+|<[=!]|[:=!]|[a-z]+\))"
)


def words_compared(module: Module) -> list[str]:
    """Comparisons of words of the input with English words that are written there."""
    literals = _named_literals(module.tree)
    functions = [node for node in ast.walk(module.tree) if isinstance(node, ast.FunctionDef)]
    found = set()
    for scope in (module.tree, *functions):
        said = _names_of_what_was_said(scope)
        for node in ast.walk(scope):
            if any(_is_said(one, said) and _has_word(other, literals) for one, other in _compared(node)):
                found.add((node.lineno, ast.unparse(node)))
    return [f"{module.file}:{line}: {text}" for line, text in sorted(found)]


def _compared(node: ast.AST) -> Iterator[tuple[ast.expr, ast.expr]]:
    """What is compared with what: both ways round, as either may be what was said."""
    if isinstance(node, ast.Compare):
        sides = [node.left, *node.comparators]
        pairs = list(itertools.pairwise(sides))
    elif isinstance(node, ast.BinOp) and isinstance(node.op, ast.BitAnd | ast.Sub):
        pairs = [(node.left, node.right)]
    elif isinstance(node, ast.Subscript):
        pairs = [(node.value, node.slice)]
    elif isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
        method, object_ = node.func.attr, node.func.value
        arguments = node.args if method in COMPARING | MATCHING | LOOKING_UP else []
        pairs = [(object_, argument) for argument in arguments]
        if method == "get" and node.args:
            yield node.args[0], object_
    else:
        pairs = []
    for one, other in pairs:
        yield one, other
        yield other, one


def _names_of_what_was_said(scope: ast.AST) -> frozenset[str]:
    """Names of what was said, and of what was made of it in the same function."""
    names = set(SAID)
    for _ in range(2):
        for node in ast.walk(scope):
            targets: list[ast.expr] = []
            if isinstance(node, ast.Assign | ast.NamedExpr) and _is_said(node.value, frozenset(names)):
                targets = node.targets if isinstance(node, ast.Assign) else [node.target]
            elif isinstance(node, ast.comprehension | ast.For) and _is_said(node.iter, frozenset(names)):
                targets = [node.target]
            names |= {one.id for one in targets if isinstance(one, ast.Name)}
    return frozenset(names)


def _is_said(node: ast.expr, names: frozenset[str]) -> bool:
    """Whether an expression is what was said, by a name or an attribute, some of it, or a form of it."""
    if isinstance(node, ast.Attribute):
        return node.attr in SAID
    if isinstance(node, ast.Name):
        return node.id in names
    if isinstance(node, ast.Subscript):
        return _is_said(node.value, names)
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
        return node.func.attr not in MATCHING | LOOKING_UP and _is_said(node.func.value, names)
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
        makes = node.func.id in ("set", "frozenset", "list", "tuple", "sorted", "str")
        return makes and any(_is_said(one, names) for one in node.args)
    if isinstance(node, ast.SetComp | ast.ListComp | ast.GeneratorExp):
        return _is_said(node.elt, names)
    return False


def _has_word(node: ast.expr, literals: frozenset[str]) -> bool:
    """Whether an expression is, or holds, an English word that is written there or in a constant."""
    if isinstance(node, ast.Constant):
        return isinstance(node.value, str) and WORD.search(node.value) is not None
    if isinstance(node, ast.Name):
        return node.id in literals
    if isinstance(node, ast.Set | ast.Tuple | ast.List):
        return any(_has_word(one, literals) for one in node.elts)
    if isinstance(node, ast.BinOp):
        return _has_word(node.left, literals) or _has_word(node.right, literals)
    return False


def _named_literals(tree: ast.Module) -> frozenset[str]:
    """Constants of a module that hold English words, as sets, tables, texts or patterns."""
    names: set[str] = set()
    for node in tree.body:
        if isinstance(node, ast.Assign | ast.AnnAssign) and node.value is not None:
            targets = node.targets if isinstance(node, ast.Assign) else [node.target]
            if _writes_words(node.value, names):
                names |= {one.id for one in targets if isinstance(one, ast.Name)}
    return frozenset(names)


def _writes_words(value: ast.expr, names: set[str]) -> bool:
    pattern = isinstance(value, ast.Call) and ast.unparse(value.func) == "re.compile"
    for node in ast.walk(value):
        if isinstance(node, ast.Name) and node.id in names:
            return True
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            text = NO_WORDS_OF_A_PATTERN.sub(" ", node.value) if pattern else node.value
            if WORD.search(text):
                return True
    return False


@pytest.mark.parametrize(
    "source",
    [
        "if word.said == 'little': pass",
        "found = [word for word in parts if word.said in ('a', 'an')]",
        "_MINE = frozenset({'my', 'our'})\nowned = piece.text in _MINE",
        "_LINES = 'and or'\n_BOTH = frozenset(_LINES.split())\nknown = _BOTH & set(link.said.split())",
        "_SAYS = re.compile(r'(?:say|tell)\\b')\ntold = _SAYS.match(text)",
        "_GENDER = {'him': 'male'}\ngender = _GENDER.get(word.said)",
        "def first(word):\n    lowered = word.said.lower()\n    return lowered.startswith('to ')",
    ],
)
def test_a_word_of_the_input_that_is_compared_with_a_literal_is_found(source):
    assert words_compared(parse(source, "executive/language/example.py"))


@pytest.mark.parametrize(
    "source",
    [
        "if word.word_class == 'NAME': pass",
        "if word.meaning == 'left': pass",
        "if piece.text == ',' or piece.text.endswith(\"'s\"): pass",
        "raise trouble(f'where to put {word.said!r}?')",
        "_MARKS = frozenset('.;!?')\nended = piece.text in _MARKS",
        "_FORM = re.compile(r'(?:[^\\W\\d_])+')\nfits = _FORM.fullmatch(said)",
        "if nominal.sort == 'thing' and nominal.said == other.said: pass",
    ],
)
def test_what_the_words_mean_may_be_compared(source):
    assert words_compared(parse(source, "executive/language/example.py")) == []


def test_no_word_of_the_input_is_compared_with_a_literal():
    understanding = [
        module
        for module in modules()
        if module.name.startswith(UNDERSTANDS) or module.name in UNDERSTANDS_TOO
    ]

    assert [line for module in understanding for line in words_compared(module)] == []
