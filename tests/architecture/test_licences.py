"""What the product needs at run time may be used by everybody."""

import importlib.metadata
import re

import pytest
from source import ROOT

PERMISSIVE = re.compile(
    r"\b(MIT|BSD|Apache|ISC|Zlib|BSL-1\.0|PSF|Python Software Foundation|Unlicense|HPND|0BSD)", re.IGNORECASE
)
COPYLEFT = re.compile(r"\b(A?GPL|LGPL|MPL|EPL|CC-BY-SA|SSPL)", re.IGNORECASE)
# Metadata that does not say it well; docs/reference/licences.md explains each.
EXPLAINED = {"cmeel-qhull", "jrl-cmakemodules"}


def locked():
    lines = (ROOT / "requirements.lock").read_text("utf-8").splitlines()
    return [line.split("==")[0] for line in lines if line and not line.startswith("#")]


def licence_of(name):
    metadata = importlib.metadata.metadata(name)
    texts = [metadata.get("License-Expression") or "", (metadata.get("License") or "").split("\n")[0]]
    texts += [c for c in metadata.get_all("Classifier") or [] if c.startswith("License ::")]
    return " | ".join(text for text in texts if text)


@pytest.mark.parametrize("name", locked())
def test_a_locked_dependency_is_permissive(name):
    if name in EXPLAINED:
        assert name in (ROOT / "docs" / "reference" / "licences.md").read_text("utf-8")
        return
    licence = licence_of(name)
    assert PERMISSIVE.search(licence), f"{name}: {licence or 'no licence named'}"
    assert not COPYLEFT.search(licence), f"{name}: {licence}"


def test_locks_pin_every_dependency_and_name_no_host():
    for file in ("requirements.lock", "requirements-dev.lock"):
        text = (ROOT / file).read_text("utf-8")
        lines = [line for line in text.splitlines() if line and not line.startswith("#")]
        assert all(re.fullmatch(r"[\w.-]+==[\w.]+", line) for line in lines), file
        assert "://" not in text
        assert len(set(lines)) == len(lines)


def test_the_locks_agree():
    runtime, development = (
        set((ROOT / file).read_text("utf-8").split())
        for file in ("requirements.lock", "requirements-dev.lock")
    )
    assert {pin for pin in runtime if "==" in pin} <= development
