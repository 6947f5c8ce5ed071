"""A run as JUnit XML, so that continuous integration systems show scripts like tests."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ElementTree
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from executive.errors import NotWritableError
from executive.exit_codes import ExitCode
from executive.reports.feedback import failure_lines, result_line

if TYPE_CHECKING:
    from executive.reports.check_report import CheckReport
    from executive.scripts.script_run import Said

# What XML 1.0 has no way to write.
_FORBIDDEN = re.compile("[^\t\n\r\u0020-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def junit_xml(name: str, results: Sequence[Said]) -> str:
    """One test case for each statement that was begun.

    A statement that did not end as expected is a failure; its seconds are simulated time.
    """
    suite = ElementTree.Element("testsuite", name=_clean(name))
    total_s, failures = 0.0, 0
    for number, (statement, said) in enumerate(results, 1):
        last = said[-1]
        seconds = sum(result.times.simulated_s for result in said)
        total_s += seconds
        text = " ".join(_clean(statement.parsed.text).split())[:200]
        case = ElementTree.SubElement(
            suite, "testcase", classname=_clean(name), name=f"{number}: {text}", time=f"{seconds:.3f}"
        )
        if last.outcome != statement.expect:
            failures += 1
            told = f"expected {statement.expect}, got {last.outcome}"
            failure = ElementTree.SubElement(case, "failure", type=last.outcome, message=told)
            refusal = statement.parsed.refusal
            lines = (
                [str(refusal)] if refusal is not None else [result_line(last), *failure_lines(last.failure)]
            )
            failure.text = _clean("\n".join(lines))
        elif last.failure is not None:
            ElementTree.SubElement(case, "system-out").text = _clean("\n".join(failure_lines(last.failure)))
    suite.attrib.update(tests=str(len(results)), failures=str(failures), errors="0", time=f"{total_s:.3f}")
    return _document(suite)


def write_check_junit(path: Path, name: str, check: CheckReport) -> None:
    """Write one test case: what was judged without moving, which fails unless it is safe.

    Raises:
        NotWritableError: The file cannot be written.
    """
    failed = check.exit_code is not ExitCode.DONE
    suite = ElementTree.Element("testsuite", name=_clean(name), tests="1", failures=str(int(failed)))
    suite.attrib.update(errors="0", time="0.000")
    shown = " ".join(_clean(name).split())[:200]
    case = ElementTree.SubElement(
        suite, "testcase", classname=_clean(name), name=f"check: {shown}", time="0.000"
    )
    if failed:
        failure = ElementTree.SubElement(case, "failure", type=check.outcome, message=_clean(check.message))
        failure.text = _clean("\n".join(check.lines()))
    _write(path, _document(suite))


def _document(suite: ElementTree.Element) -> str:
    suites = ElementTree.Element("testsuites")
    suites.append(suite)
    ElementTree.indent(suites)
    return ElementTree.tostring(suites, encoding="unicode", xml_declaration=True) + "\n"


def write_junit(path: Path, name: str, results: Sequence[Said]) -> None:
    """Write the document.

    Raises:
        NotWritableError: The file cannot be written.
    """
    _write(path, junit_xml(name, results))


def _write(path: Path, document: str) -> None:
    try:
        path.write_text(document, "utf-8")
    except OSError as failed:
        raise NotWritableError(path, failed) from failed


def _clean(text: str) -> str:
    return _FORBIDDEN.sub("\ufffd", text)
