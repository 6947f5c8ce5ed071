"""Suites over the door of the Model Context Protocol: tasks whose clients come and go, and hostile calls.

Its library is loaded by who runs them: it takes half a second.
"""

from __future__ import annotations

import argparse

from rich.console import Console


def run_mcp_suites(options: argparse.Namespace, messages: Console) -> int:
    """Tasks by every kind of client, or calls with arguments at random."""
    if options.suite == "mcp-fuzz":
        from tools.evaluate.mcp.fuzz import run_mcp_fuzz

        return run_mcp_fuzz(options, messages)
    from tools.evaluate.mcp.tasks import run_mcp

    return run_mcp(options, messages)
