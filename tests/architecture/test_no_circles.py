"""No circle of modules: imports, late ones and those for types among them, lead nowhere back."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Set

import pytest
from source import Module, modules, parse


def import_graph(among: tuple[Module, ...]) -> dict[str, set[str]]:
    """Which of these modules each of them imports, wherever in the file."""
    names = {module.name for module in among}
    return {
        module.name: {_module_of(name, names) for _line, name in module.imports()} - {"", module.name}
        for module in among
    }


def _module_of(name: str, names: Set[str]) -> str:
    """The module that a dotted name is, or is in; nothing where it is none of these."""
    while name and name not in names:
        name = name.rpartition(".")[0]
    return name


def circles(graph: Mapping[str, Set[str]]) -> list[list[str]]:
    """Strongly connected components of more than one module, by Tarjan's algorithm, without recursion."""
    number: dict[str, int] = {}
    lowest: dict[str, int] = {}
    path: list[str] = []
    found = []
    for root in graph:
        work: list[tuple[str, Iterator[str]]] = []
        if root not in number:
            _enter(root, graph, number, lowest, path, work)
        while work:
            name, following = work[-1]
            target = next(following, None)
            if target is None:
                work.pop()
                if work:
                    lowest[work[-1][0]] = min(lowest[work[-1][0]], lowest[name])
                if lowest[name] == number[name]:
                    at = path.index(name)
                    component, path[at:] = path[at:], []
                    if len(component) > 1:
                        found.append(sorted(component))
            elif target not in number:
                _enter(target, graph, number, lowest, path, work)
            elif target in path:
                lowest[name] = min(lowest[name], number[target])
    return found


def _enter(
    name: str,
    graph: Mapping[str, Set[str]],
    number: dict[str, int],
    lowest: dict[str, int],
    path: list[str],
    work: list[tuple[str, Iterator[str]]],
) -> None:
    number[name] = lowest[name] = len(number)
    path.append(name)
    work.append((name, iter(sorted(graph.get(name, ())))))


@pytest.mark.parametrize(
    ("graph", "expected"),
    [
        ({"a": {"b"}, "b": {"c"}, "c": set()}, []),
        ({"a": {"b", "c"}, "b": {"c"}, "c": set()}, []),
        ({"a": {"b"}, "b": {"a"}}, [["a", "b"]]),
        ({"a": {"b"}, "b": {"c"}, "c": {"d"}, "d": {"b", "e"}, "e": set()}, [["b", "c", "d"]]),
        ({"a": {"b"}, "b": {"a", "c"}, "c": {"d"}, "d": {"c"}}, [["c", "d"], ["a", "b"]]),
    ],
)
def test_circles_are_found(graph, expected):
    assert circles(graph) == expected


def test_a_circle_through_a_late_import_and_one_for_types_is_found():
    late = parse("def f():\n    from trees.b import g", "trees/a.py")
    typed = parse("if TYPE_CHECKING:\n    import trees.a", "trees/b.py")

    assert circles(import_graph((late, typed))) == [["trees.a", "trees.b"]]


def test_a_module_that_is_imported_from_its_package_counts_as_itself():
    whole = parse("", "trees/room/__init__.py")
    one = parse("from trees.room import two", "trees/room/one.py")
    two = parse("", "trees/room/two.py")

    assert import_graph((whole, one, two))["trees.room.one"] == {"trees.room.two"}


def test_no_module_leads_back_to_itself():
    found = circles(import_graph(modules()))

    assert not found, "\n".join(" <-> ".join(circle) for circle in found)
