"""What every test shares: one thread a process, no wall-clock deadlines, marks as properties of reports."""

import ctypes
import gc
import os
import signal

os.environ.setdefault("OMP_NUM_THREADS", "1")

import pytest
from hypothesis import HealthCheck, settings

gc.disable()  # until everything is imported

settings.register_profile(
    "repeatable", derandomize=True, deadline=None, suppress_health_check=[HealthCheck.too_slow]
)
settings.register_profile("long", settings.get_profile("repeatable"), max_examples=500)
settings.load_profile("repeatable")

MOST_LOOKED_THROUGH = 100_000
"""Objects: to go through so many takes a tenth of a second."""
_file_under_way = None


def _has_opengl() -> bool:
    """Whether a library that draws without a display is there; found without importing MuJoCo."""
    for name in ("libEGL.so.1", "libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"):
        try:
            ctypes.CDLL(name)
        except OSError:
            continue
        return True
    return False


def pytest_addoption(parser):
    """Tests beside other programs take minutes and run when they are asked for."""
    parser.addoption("--peers", action="store_true", help="run tests/peers as well: `make test-peers`")


def pytest_ignore_collect(collection_path, config):
    """Leave out what needs other programs."""
    is_peer = collection_path.name == "peers" and collection_path.parent.name == "tests"
    return True if is_peer and not config.getoption("--peers") else None


def pytest_collection_finish():
    """Keep what imports made out of every later collection of garbage: it lives as long as the tests do.

    Going through it again and again, and so often through the trees of a test, was an eighth of the time of
    ``tests/trees``: trees are rings of parents and children, seldom garbage before their test has ended.
    """
    gc.freeze()
    gc.set_threshold(50_000, 20, 100)
    gc.enable()


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_setup(item):
    """Between files, keep what has grown out of later collections too: dictionaries that are made once.

    The tables of the language are half a million objects. Whatever asks for a collection, as the served
    executive does after every order, went through them each time: half a second.
    """
    global _file_under_way
    if item.path == _file_under_way:
        return
    _file_under_way = item.path
    if len(gc.get_objects()) > MOST_LOOKED_THROUGH:
        gc.collect()
        gc.freeze()


def pytest_collection_modifyitems(items):
    """Skip pictures where they cannot be drawn; tell reports which requirements a test proves.

    What takes minutes begins first: at the end it would keep one core busy and leave the others idle.
    """
    items.sort(key=lambda item: item.get_closest_marker("minutes") is None)
    drawing = [item for item in items if item.get_closest_marker("opengl")]
    if drawing and not _has_opengl():
        for item in drawing:
            item.add_marker(pytest.mark.skip(reason="no OpenGL library (Debian: libegl1 or libosmesa6)"))
    for item in items:
        for marker in item.iter_markers("requirement"):
            item.user_properties.extend(("requirement", name) for name in marker.args)


@pytest.fixture
def signals_heard():
    """Signals to end are heard in the test, and by processes that it begins, however the tests were begun.

    Under ``nohup`` SIGHUP is ignored, in the background of a script SIGINT, by children too: who waits for
    what they do would wait for minutes, and count the test as failed.
    """
    usual = {
        signal.SIGINT: signal.default_int_handler,
        signal.SIGTERM: signal.SIG_DFL,
        signal.SIGHUP: signal.SIG_DFL,
    }
    before = {number: signal.getsignal(number) for number in usual}
    for number, handler in before.items():
        if handler is signal.SIG_IGN:
            signal.signal(number, usual[number])
    yield
    for number, handler in before.items():
        signal.signal(number, handler)
