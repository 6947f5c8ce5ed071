"""What asks a model's server: ``python -m executive.doors.model.model_process NAME DESCRIPTOR``."""

from __future__ import annotations

import sys

from executive.config import config_files, environment_value
from executive.doors.model.client import ModelClient
from executive.front.model_settings import model_called
from robots.live.wire.child_process import serve_parent


def main() -> int:
    """Answer questions, each the messages of one request, until the parent ends."""
    name, descriptor = sys.argv[1:]
    settings = model_called(name, config_files())
    key = environment_value(settings.key_env) if settings.key_env else ""
    serve_parent(int(descriptor), ModelClient(settings, key).ask)
    return 0


if __name__ == "__main__":
    sys.exit(main())
