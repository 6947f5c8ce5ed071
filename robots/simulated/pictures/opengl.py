"""Find a way to draw without a display: EGL, or OSMesa.

MuJoCo chooses its library from the environment when it is imported, and the import fails when that
library is missing. So its choice is left alone; a context is made here, from the library that is there.
"""

from __future__ import annotations

import ctypes
import importlib
from typing import Protocol

from robots.errors import RenderingUnavailableError

DEBIAN_PACKAGES = "libegl1 (with libgl1-mesa-dri) or libosmesa6"
_EGL_LIBRARIES = ("libEGL.so.1", "libEGL.so")
_OSMESA_LIBRARIES = ("libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so")
_EGL_PLATFORM_DEVICE = 0x313F
_MAX_DEVICES = 16


class Context(Protocol):
    """An OpenGL context of MuJoCo's."""

    def make_current(self) -> None:
        """Draw into it from now on."""
        ...

    def free(self) -> None:
        """Give it back."""
        ...


def require_opengl() -> None:
    """Find out whether pictures can be drawn on this machine; draws nothing.

    Raises:
        RenderingUnavailableError: No usable library is installed; names the Debian packages.
    """
    _backends()


def make_context(width: int, height: int) -> Context:
    """Make an OpenGL context for pictures of a size.

    Raises:
        RenderingUnavailableError: No usable library is installed, or none of them works.
    """
    reasons = []
    for backend in _backends():
        try:
            context: Context = importlib.import_module(f"mujoco.{backend}").GLContext(width, height)
            context.make_current()
        # Drivers fail in ways of their own (ctypes, PyOpenGL, MuJoCo); each only rules out one backend.
        except Exception as failed:
            reasons.append(f"{backend}: {failed}")
        else:
            return context
    raise RenderingUnavailableError(f"no OpenGL library works here ({'; '.join(reasons)})")


def _backends() -> list[str]:
    found = []
    if any(_egl_has_device(name) for name in _EGL_LIBRARIES):
        found.append("egl")
    if any(_library(name) is not None for name in _OSMESA_LIBRARIES):
        found.append("osmesa")
    if not found:
        raise RenderingUnavailableError(
            f"pictures need an OpenGL library; install the Debian package {DEBIAN_PACKAGES}"
        )
    return found


def _library(name: str) -> ctypes.CDLL | None:
    try:
        return ctypes.CDLL(name)
    except OSError:
        return None


def _egl_has_device(name: str) -> bool:
    """Tell whether an EGL library can open a display on one of its devices.

    The library alone proves nothing: without a driver it is there and cannot draw.
    """
    library = _library(name)
    if library is None:
        return False
    pointer = ctypes.c_void_p
    try:
        library.eglGetProcAddress.restype = pointer
        query = library.eglGetProcAddress(b"eglQueryDevicesEXT")
        display_of = library.eglGetProcAddress(b"eglGetPlatformDisplayEXT")
        if not query or not display_of:
            return False
        devices, count = (pointer * _MAX_DEVICES)(), ctypes.c_int(0)
        query_type = ctypes.CFUNCTYPE(ctypes.c_uint, ctypes.c_int, pointer, pointer)
        if not query_type(query)(_MAX_DEVICES, devices, ctypes.byref(count)):
            return False
        display_type = ctypes.CFUNCTYPE(pointer, ctypes.c_uint, pointer, pointer)
        library.eglInitialize.argtypes = [pointer, pointer, pointer]
        for device in devices[: count.value]:
            display = display_type(display_of)(_EGL_PLATFORM_DEVICE, device, None)
            if display and library.eglInitialize(display, None, None):
                return True
    except AttributeError:
        return False
    return False
