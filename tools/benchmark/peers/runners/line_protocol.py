"""Questions as JSON lines on standard input, answers as JSON lines on standard output.

Runs in a peer's environment: it knows the standard library alone.
"""

from __future__ import annotations

import json
import os
import sys
import traceback
from collections.abc import Callable, Mapping
from typing import Any

Document = dict[str, Any]
Handler = Callable[[Document], Document]


def serve(handlers: Mapping[str, Handler]) -> None:
    """Answer until the input ends; ``ask`` in a question names its handler.

    What a library prints goes to standard error, so that it cannot be taken for an answer.
    """
    answers = os.fdopen(os.dup(sys.stdout.fileno()), "w", encoding="utf-8")
    os.dup2(sys.stderr.fileno(), sys.stdout.fileno())
    for line in sys.stdin:
        question = json.loads(line)
        try:
            answer = handlers[question["ask"]](question)
        except Exception:  # the other side decides what a peer's failure means
            answer = {"error": traceback.format_exc(limit=4)}
        answers.write(json.dumps(answer) + "\n")
        answers.flush()
