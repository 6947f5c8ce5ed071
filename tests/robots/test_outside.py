"""Scenes, robots and words of other packages: found by entry points, and left out with a reason."""

import shutil
import subprocess
import sys
from importlib.metadata import EntryPoint
from pathlib import Path

import pytest

import robots
from executive.vocabulary.word_lists import outside_words
from robots import outside
from robots.errors import SceneError, UnknownRobotError
from robots.models.description import load_description
from robots.outside import known_robots, known_scenes
from robots.scenes.scene_file import load_scene

MODELS, SCENES = (Path(robots.__file__).parent / name for name in ("models", "scenes"))


@pytest.fixture
def package(tmp_path, monkeypatch):
    """Installs a package of data: ``package(group, name, files)``, each file with its text."""
    points = []

    def install(group, name, files, value=None):
        folder = tmp_path / f"data_{len(points)}"
        folder.mkdir()
        (folder / "__init__.py").write_text("")
        for file, text in files.items():
            (folder / file).write_text(text)
        points.append(EntryPoint(name, value or folder.name, group))
        return folder

    def found(group):
        return tuple(point for point in points if point.group == group)

    monkeypatch.syspath_prepend(str(tmp_path))
    monkeypatch.setattr(outside.importlib.metadata, "entry_points", found)
    forget()
    yield install
    forget()
    for name in [name for name in sys.modules if name.startswith("data_")]:
        del sys.modules[name]


def forget():
    outside.outside_folders.cache_clear()
    outside.outside_files.cache_clear()
    outside_words.cache_clear()


def test_a_scene_of_another_package_is_known_and_read(package):
    text = (SCENES / "tabletop.toml").read_text().replace("red", "green")
    package(outside.SCENES, "theatre", {"stage.toml": text})

    assert "stage" in known_scenes()
    assert load_scene("stage").objects[0].color == "green"


def test_a_scene_of_another_package_does_not_replace_one_of_the_products(package):
    package(outside.SCENES, "theatre", {"tabletop.toml": "nonsense"})

    assert load_scene("tabletop").objects
    assert known_scenes().count("tabletop") == 1


def test_a_scene_of_another_package_that_is_none_is_refused_with_its_name(package):
    package(outside.SCENES, "theatre", {"stage.toml": "nonsense"})

    with pytest.raises(SceneError, match=r"stage.toml"):
        load_scene("stage")


def test_a_robot_of_another_package_is_known_by_the_name_of_its_entry_point(package):
    folder = package(outside.ROBOTS, "marcello", {})
    for file in (MODELS / "talos").iterdir():
        if file.is_file():
            shutil.copy(file, folder)

    assert "marcello" in known_robots()
    assert load_description("marcello").name == "marcello"
    assert load_description("marcello").joints == load_description("talos").joints


def test_a_package_without_a_description_is_no_robot(package):
    package(outside.ROBOTS, "ghost", {})

    assert "ghost" not in known_robots()
    with pytest.raises(UnknownRobotError):
        load_description("ghost")


def test_what_cannot_be_imported_is_left_out_and_told(package):
    package(outside.SCENES, "gone", {}, value="no_such_package")
    package(outside.SCENES, "good", {})
    package(outside.SCENES, "good", {})

    found = outside.outside_folders(outside.SCENES)

    assert list(found.folders) == ["good"]
    assert len(found.complaints) == 2
    assert any("no_such_package" in line for line in found.complaints)


CLASSES = frozenset({"KIND", "NAME"})


def test_words_of_another_package_are_read(package):
    package(outside.VOCABULARY, "theatre", {"props.toml": '[vocabulary.KIND]\nwords.crown = ["crown"]\n'})

    ((source, tables),) = outside_words(CLASSES).words

    assert source == "words 'props'"
    assert tables == {"KIND": {"words": {"crown": ["crown"]}}}


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("vocabulary = 3", "must be a table"),
        ("[other]", "KeyError"),
        ("= nonsense", "TomlTextError"),
        ('[vocabulary.GHOST]\nsame = ["x"]', "no word class 'GHOST'"),
        ('[vocabulary.KIND]\nrefusal = "no"', "needs words or same"),
        ('[vocabulary.KIND]\nsame = [""]', "are lists of phrases"),
        ('[vocabulary.KIND]\nwords.crown = "crown"', "are lists of phrases"),
    ],
)
def test_words_that_are_none_are_left_out_and_told_and_others_stay(package, text, words):
    package(outside.VOCABULARY, "bad", {"bad.toml": text})
    package(outside.VOCABULARY, "good", {"good.toml": '[vocabulary.NAME]\nsame = ["zorblina"]'})

    found = outside_words(CLASSES)

    assert [source for source, _ in found.words] == ["words 'good'"]
    (complaint,) = found.complaints
    assert complaint.startswith("words 'bad'")
    assert words in complaint


def test_an_ordinary_process_finds_nothing_from_outside():
    script = (
        "from robots import outside as o;"
        "print([len(o.outside_folders(group).folders) for group in (o.SCENES, o.ROBOTS)])"
    )

    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)

    assert done.stdout.strip() == "[0, 0]"
