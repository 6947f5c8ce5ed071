"""The wheel carries everything that the product needs, and nothing of what only its developers need."""

import os
import shutil
import subprocess
import sys
import venv
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
# The first use compiles for two minutes, and for ten where others compute on the same cores.
PATIENCE_S = 1500
pytestmark = pytest.mark.minutes
PACKAGES = ("executive", "trees", "robots", "kinematics")


@pytest.fixture(scope="module")
def wheel(tmp_path_factory):
    """Built from a copy of the sources, so that nothing of the checkout's state gets in."""
    source, target = tmp_path_factory.mktemp("source"), tmp_path_factory.mktemp("wheel")
    for name in (*PACKAGES, "tools", "tests", "pyproject.toml", "README.md", "LICENSE"):
        path = ROOT / name
        if path.is_dir():
            shutil.copytree(path, source / name, ignore=shutil.ignore_patterns("__pycache__"))
        else:
            shutil.copy(path, source / name)
    build = [sys.executable, "-m", "pip", "wheel", "--quiet", "--no-deps", "--no-build-isolation"]
    subprocess.run([*build, "--wheel-dir", str(target), str(source)], check=True, timeout=120)
    (file,) = target.glob("*.whl")
    return file


@pytest.fixture(scope="module")
def installed(wheel, tmp_path_factory):
    """The folder of programs of an empty environment, with the wheel and what it asks the registry for."""
    folder = tmp_path_factory.mktemp("installed")
    venv.create(folder, with_pip=True)
    programs = folder / "bin"
    install = [programs / "python", "-m", "pip", "install", "--quiet", "-c", ROOT / "requirements.lock"]
    subprocess.run([*install, wheel], check=True, timeout=PATIENCE_S)
    return programs


def ran(program, folder, *arguments):
    """Run a program of the environment somewhere else, with nothing of ours or of the user's around it."""
    environment = {"PATH": os.defpath, "HOME": str(folder), "OMP_NUM_THREADS": "1"}
    return subprocess.run(
        [program, *arguments],
        cwd=folder,
        env=environment,
        capture_output=True,
        text=True,
        timeout=PATIENCE_S,
        check=False,
    )


def test_the_wheel_holds_every_data_file_of_the_packages(wheel):
    inside = set(zipfile.ZipFile(wheel).namelist())
    data = {
        path.relative_to(ROOT).as_posix()
        for package in PACKAGES
        for path in (ROOT / package).rglob("*")
        if path.suffix in (".toml", ".lark", ".py", ".typed") or path.name == "py.typed"
        if "__pycache__" not in path.parts
    }

    assert data
    assert data <= inside


def test_the_wheel_holds_neither_tools_nor_tests(wheel):
    folders = {name.split("/")[0] for name in zipfile.ZipFile(wheel).namelist()}

    assert {name for name in folders if not name.endswith(".dist-info")} == set(PACKAGES)


@pytest.mark.requirement("U5")
@pytest.mark.timeout(2 * PATIENCE_S)
def test_the_installed_wheel_does_the_main_job_from_another_folder(installed, tmp_path):
    where = ran(installed / "python", tmp_path, "-c", "import executive, robots; print(executive, robots)")
    assert where.stdout.count(str(installed.parent)) == 2, where.stderr

    sentence, runs = "pick up the red cup on the table", str(tmp_path / "runs")
    done = ran(installed / "executive", tmp_path, "run", sentence, "--record", runs)

    assert done.returncode == 0, done.stderr[-2000:]
    assert "Traceback" not in done.stderr
