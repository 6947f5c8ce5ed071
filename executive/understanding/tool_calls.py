r"""Tool calls as models send them, turned into the steps that they mean.

    {"name": "pick", "arguments": {"object": {"kind": "cup"}}}
    {"tool_calls": [{"type": "function", "function": {"name": "pick", "arguments": "{\"object\": ...}"}}]}

A tool is named as an action is, and its arguments are the action's slots, as an object or as the text of
one; a tool ``command`` has one argument, a sentence. A tool call has no place for a confidence: who calls a
tool has decided. One that its arguments tell counts as that of any other step does.
"""

from __future__ import annotations

from typing import Any

from executive.understanding.untrusted_json import UntrustedJsonError, read_json

SURE = 1.0
"""Confidence of a call that tells none."""

_AROUND_CALLS = {"tool_calls", "role", "content", "refusal", "annotations", "audio", "reasoning_content"}
_AROUND_CALL = {"id", "call_id", "index", "type", "status"}
_TYPES = ("function", "function_call", "tool_call", "tool_use")
SENTENCE_TOOL = "command"


class ToolCallError(Exception):
    """A tool call of another shape; the message says where and why."""


def steps_of_calls(document: Any) -> list[tuple[str, dict[str, Any]]] | None:
    """Place and step of each tool call of a document; None when it is something else.

    Raises:
        ToolCallError: It is a tool call, but not such a one.
    """
    if isinstance(document, dict) and "tool_calls" in document:
        _only(document, _AROUND_CALLS, "")
        if document.get("content") not in (None, ""):
            raise ToolCallError("content: there must be no words beside 'tool_calls'")
        calls, place = document["tool_calls"], "tool_calls"
        if not isinstance(calls, list):
            raise ToolCallError("tool_calls: must be a list")
        return [_step(call, f"{place}[{i}]") for i, call in enumerate(calls)]
    if _is_call(document):
        return [_step(document, "")]
    if isinstance(document, list) and document and all(map(_is_call, document)):
        return [_step(call, f"[{i}]") for i, call in enumerate(document)]
    return None


def _is_call(item: Any) -> bool:
    """Whether something is meant as a tool call, rather than as a step of our own."""
    if not isinstance(item, dict) or {"command", "action", "steps"} & set(item):
        return False
    return bool({"function", "function_call"} & set(item)) or (
        "name" in item and bool({"arguments", "input", "parameters"} & set(item))
    )


def _step(call: Any, place: str) -> tuple[str, dict[str, Any]]:
    if not isinstance(call, dict):
        raise ToolCallError(f"{place or 'it'} must be an object with 'name' and 'arguments'")
    for key in ("function", "function_call"):
        if isinstance(call.get(key), dict):
            _only(call, {key, *_AROUND_CALL}, place)
            return _step(call[key], _at(place, key))
    if call.get("type", "function") not in _TYPES:
        raise ToolCallError(f"{_at(place, 'type')}: {str(call['type'])[:40]!r} is no tool call")
    given = [key for key in ("arguments", "input", "parameters") if key in call]
    if len(given) > 1:
        raise ToolCallError(f"{_at(place, given[1])}: there are {given[0]!r} already")
    _only(call, {"name", *given, *_AROUND_CALL}, place)
    name = call.get("name")
    if not isinstance(name, str):
        raise ToolCallError(f"{_at(place, 'name')} must be the name of an action")
    where = _at(place, given[0] if given else "arguments")
    arguments = _arguments(call[given[0]] if given else {}, where)
    if name == SENTENCE_TOOL:
        return where, arguments
    if "action" in arguments:
        raise ToolCallError(f"{where}.action: the tool's name says it")
    return where, {"action": name, **arguments}


def _arguments(value: Any, where: str) -> dict[str, Any]:
    """Arguments as an object, or as the JSON text of one."""
    if value is None or value == "":
        return {}
    if isinstance(value, str):
        try:
            value = read_json(value)
        except UntrustedJsonError as wrong:
            raise ToolCallError(f"{where}: {wrong}") from wrong
    if not isinstance(value, dict):
        raise ToolCallError(f"{where} must be an object, or the JSON text of one")
    return value


def _only(item: dict[str, Any], known: set[str], place: str) -> None:
    extra = sorted(set(item) - known)
    if extra:
        raise ToolCallError(f"unknown key {extra[0][:40]!r} in {place or 'the tool call'}")


def _at(place: str, key: str) -> str:
    return f"{place}.{key}" if place else key
