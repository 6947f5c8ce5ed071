"""Checks of the machine, each with the fix for what it finds missing."""

from __future__ import annotations

import importlib.metadata
import importlib.util
import platform
import re
import shutil
import sys
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from executive.config import config_files, environment_value, runs_directory
from executive.errors import ExecutiveError
from robots.errors import RenderingUnavailableError

if TYPE_CHECKING:
    from executive.front.model_settings import ModelSettings

MIN_PYTHON = (3, 11)
_PRODUCT = "humanoid-executive"

_REQUIRED_NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9._-]*")


@dataclass(frozen=True, slots=True)
class Finding:
    """The result of one check of this machine: a library, a compiler, a device.

    Attributes:
        name: What.
        ok: Whether it is there and works.
        detail: What was found.
        fix: What to do when it is not.
        needed: Whether the main job needs it.
    """

    name: str
    ok: bool
    detail: str
    fix: str = ""
    needed: bool = True


_WARMING_TASK = "pick up the red cup on the table"


def diagnose() -> list[Finding]:
    """Look at everything that the product needs."""
    findings = [_python(), *_packages()]
    findings += [_data("robots", _robots), _data("scenes", _scenes), _data("words", _words)]
    return [*findings, _writable(), _kernel(), _opengl(), _ffmpeg(), *_models()]


def warm_up(tell: Callable[[str], None] = lambda _: None) -> str:
    """Load the robot and the planner once, so that everything is compiled and cached.

    Args:
        tell: Is told what is being done while it takes long.
    """
    from executive.runs.run_request import DEFAULT_ROBOT
    from executive.session.assembly import assemble
    from executive.understanding.command_parser import parse
    from kinematics.compiled import cache
    from robots.models.usual_scene import usual_scene
    from robots.scenes.scene_file import load_scene

    cache.drop_damaged()
    compile_kernel(tell)
    tell("one task, for everything else")
    scene = usual_scene(DEFAULT_ROBOT)
    assembly = assemble(DEFAULT_ROBOT, load_scene(scene), 0)
    (command,) = parse(_WARMING_TASK).commands
    result = assembly.session.run_task(command)
    return f"warm: {DEFAULT_ROBOT} in {scene}, {result.outcome}: {_WARMING_TASK}"


def compile_kernel(tell: Callable[[str], None] = lambda _: None) -> None:
    """Compile the motion kernel where that has not been done and can be kept.

    Args:
        tell: Is told what is being done.
    """
    from executive.runs.run_request import DEFAULT_ROBOT
    from kinematics import warming
    from kinematics.compiled import cache, readiness
    from kinematics.model.robot_model import RobotModel
    from robots.models.description import load_description

    if readiness.ready():
        return
    if cache.folder() is None:
        tell("the cache folder cannot be written: planning goes on without the compiled kernel, slower")
        return
    tell("compiling the motion kernel, once: a minute or two")
    warming.warm(RobotModel(load_description(DEFAULT_ROBOT)), tell)


def _python() -> Finding:
    wanted = ".".join(map(str, MIN_PYTHON))
    return Finding(
        "Python",
        sys.version_info >= MIN_PYTHON,
        platform.python_version(),
        f"install Python {wanted} or newer",
    )


def _packages() -> list[Finding]:
    """All that this package's own metadata say it runs on: none can be forgotten here."""
    try:
        required = importlib.metadata.requires(_PRODUCT) or []
    except importlib.metadata.PackageNotFoundError:
        detail = "not installed, so what it runs on is not known"
        return [Finding(_PRODUCT, False, detail, f"pip install {_PRODUCT}")]
    return [_package(*one) for one in needed_packages(required)]


def needed_packages(requirements: Iterable[str]) -> tuple[tuple[str, str], ...]:
    """Names of the distributions that are always needed, each with its requirement ("numpy>=2.1").

    Args:
        requirements: As the metadata of a distribution have them; those with a marker, as extras have one,
            are left out.
    """
    always = [one.strip() for one in requirements if ";" not in one]
    named = [(_REQUIRED_NAME.match(one), one) for one in always]
    return tuple((match.group(), one) for match, one in named if match is not None)


def _package(name: str, requirement: str) -> Finding:
    try:
        installed = importlib.metadata.distribution(name)
    except importlib.metadata.PackageNotFoundError:
        return Finding(name, False, "not installed", f'pip install "{requirement}"')
    gone = [module for module in _modules(installed) if importlib.util.find_spec(module) is None]
    if gone:
        detail = f"{installed.version}, but the module {gone[0]} is gone"
        return Finding(name, False, detail, f'pip install --force-reinstall "{requirement}"')
    return Finding(name, True, installed.version)


def _modules(installed: importlib.metadata.Distribution) -> list[str]:
    """Top-level modules that a distribution says it has, none that are no names or private."""
    told = installed.read_text("top_level.txt")
    if told is None:
        files = installed.files or ()
        told = "\n".join(
            sorted({file.parts[0] for file in files if file.name == "__init__.py" and len(file.parts) == 2})
        )
    return [name for name in told.split() if name.isidentifier() and not name.startswith("_")]


def _data(name: str, count: Callable[[], int]) -> Finding:
    fix = "pip install --force-reinstall humanoid-executive"
    try:
        number = count()
    except (OSError, ValueError, ImportError, ExecutiveError) as broken:
        return Finding(name, False, str(broken), fix)
    return Finding(name, number > 0, f"{number} found", fix)


def _robots() -> int:
    from robots.outside import known_robots

    return len(known_robots())


def _scenes() -> int:
    from robots.outside import known_scenes

    return len(known_scenes())


def _words() -> int:
    from executive.vocabulary import load_vocabulary

    return len(load_vocabulary().single_words)


def _writable() -> Finding:
    folder = runs_directory()
    probe = folder / ".probe"
    try:
        folder.mkdir(parents=True, exist_ok=True)
        probe.write_text("")
        probe.unlink()
    except OSError as failed:
        return Finding(
            "runs folder", False, f"{folder}: {failed.strerror}", "use --record DIR, or set XDG_DATA_HOME"
        )
    return Finding("runs folder", True, str(folder))


def _kernel() -> Finding:
    from kinematics.compiled import cache, readiness

    broken = cache.damaged()
    if readiness.ready() and not broken:
        return Finding("motion kernel", True, "compiled")
    detail = "not compiled yet; planning goes on without it"
    if broken:
        detail = f"{len(broken)} of its files damaged, such as {broken[0]}; what they held is compiled anew"
    return Finding("motion kernel", False, detail, "executive doctor --warm", needed=False)


def _opengl() -> Finding:
    from robots.simulated.pictures.opengl import DEBIAN_PACKAGES, require_opengl

    try:
        require_opengl()
    except RenderingUnavailableError:
        detail, fix = "none; only --snapshot and --video need it", f"apt-get install {DEBIAN_PACKAGES}"
        return Finding("OpenGL", False, detail, fix, needed=False)
    return Finding("OpenGL", True, "found")


def _models() -> list[Finding]:
    """The language models that a user has set up: where sentences go, if ``--model`` asks for one."""
    from executive.front.model_settings import ModelSettingsError, model_settings

    try:
        known = model_settings(config_files())
    except ModelSettingsError as wrong:
        return [Finding("models", False, str(wrong), "mend the file of settings", needed=False)]
    return [_model(one) for one in known.values()]


def _model(settings: ModelSettings) -> Finding:
    name = f"model {settings.name}"
    what = "every sentence goes" if settings.when == "always" else "what is not understood goes"
    detail = f"with --model {settings.name} {what} to {settings.url}, and what is seen with it"
    if settings.sees:
        detail += "; pictures of things that a camera sees go there, in every run with one"
    if importlib.util.find_spec("openai") is None:
        return Finding(name, False, detail, f'pip install "{_PRODUCT}[models]"', needed=False)
    if settings.key_env and not environment_value(settings.key_env):
        return Finding(name, False, detail, f"set {settings.key_env} to its key", needed=False)
    return Finding(name, True, detail, needed=False)


def _ffmpeg() -> Finding:
    path = shutil.which("ffmpeg")
    return Finding(
        "ffmpeg",
        path is not None,
        path or "none; only --video needs it",
        "apt-get install ffmpeg",
        needed=False,
    )
