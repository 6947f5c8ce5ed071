"""A file is one thing and needs no scrolling, a folder can be looked over, and few files are tiny."""

from __future__ import annotations

import ast
from collections import Counter

import pytest
from source import Module, modules, parse

MOST_IN_A_FOLDER = 25
MOST_LINES = 400
SMALL_LINES = 40
MOST_SMALL = 0.1
LANGUAGE = "executive/language/"


def lines(module: Module) -> int:
    """How many lines its file has."""
    return len(module.path.read_text("utf-8").splitlines())


def says_something(module: Module) -> bool:
    """Whether a file is more than the docstring of a room."""
    return module.path.name != "__init__.py" or any(not _is_docstring(node) for node in module.tree.body)


def is_one_thing(module: Module) -> bool:
    """Whether a small file is a leaf, a value type, a command or a register, as far as its top level tells.

    That is one public class, or one public function; or else types and constants alone; or functions around
    one thing that the module keeps: a cached answer, a context variable.
    """
    public = [node for node in module.tree.body if _is_public(node)]
    classes = [node for node in public if isinstance(node, ast.ClassDef)]
    functions = [node for node in public if isinstance(node, ast.FunctionDef)]
    if len(public) <= 1:
        return True
    if not functions:
        return all(map(_is_type, classes))
    return not classes and _keeps_something(module)


def _is_docstring(node: ast.stmt) -> bool:
    return isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)


def _is_public(node: ast.stmt) -> bool:
    return isinstance(node, ast.ClassDef | ast.FunctionDef) and not node.name.startswith("_")


def _is_type(node: ast.ClassDef) -> bool:
    """A dataclass, an enumeration, an error, or a table of a file: values without anything that they do."""
    bases = [ast.unparse(base).rpartition(".")[2] for base in node.bases]
    decorated = any("dataclass" in ast.unparse(decorator) for decorator in node.decorator_list)
    return decorated or any(base.endswith(("Enum", "Tuple", "Table", "Exception", "Error")) for base in bases)


def _keeps_something(module: Module) -> bool:
    written = ast.unparse(module.tree)
    return "@cache\n" in written or "@functools.cache\n" in written or "= ContextVar(" in written


@pytest.mark.parametrize(
    "source",
    [
        "class Close(Leaf):\n    pass",
        "def stop():\n    pass\n\ndef _person():\n    pass",
        "A = 1\nB = 2",
        "SKILL = Skill()\n\ndef _tree():\n    pass",
        "class A(Enum):\n    X = 1\n\n@dataclass(frozen=True)\nclass B:\n    a: A",
        "class A(Exception):\n    pass\n\nclass B(ValueError):\n    pass",
        "@cache\ndef all():\n    pass\n\ndef one(name):\n    return all()[name]",
    ],
)
def test_a_leaf_a_type_a_command_and_a_register_are_one_thing(source):
    assert is_one_thing(parse(source))


@pytest.mark.parametrize(
    "source",
    [
        "def one():\n    pass\n\ndef other():\n    pass",
        "class Look(Leaf):\n    pass\n\nclass Listen(Leaf):\n    pass",
        "class Look(Leaf):\n    pass\n\ndef look():\n    pass",
        "@dataclass\nclass Numbers:\n    a: int\n\ndef numbers():\n    pass",
    ],
)
def test_several_things_are_not_one(source):
    assert not is_one_thing(parse(source))


def test_no_folder_holds_more_modules_than_one_can_look_over():
    folders = Counter(module.path.parent for module in modules())

    assert not {str(folder): n for folder, n in folders.items() if n > MOST_IN_A_FOLDER}


def test_no_file_is_long():
    assert not {module.file: lines(module) for module in modules() if lines(module) > MOST_LINES}


def test_few_files_are_small_and_each_of_them_is_one_thing():
    counted = [one for one in modules() if says_something(one) and not one.file.startswith(LANGUAGE)]
    small = [module for module in counted if lines(module) < SMALL_LINES]

    assert not [module.file for module in small if not is_one_thing(module)]
    assert len(small) <= MOST_SMALL * len(counted), sorted(module.file for module in small)
