"""Guides lead somewhere, all of them are found from the README, and they describe today."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
LINK = re.compile(r"\]\(([^)\s#]*)(?:#([^)\s]*))?\)")
FENCED = re.compile(r"^```.*?^```", re.MULTILINE | re.DOTALL)
COMMIT = re.compile(r"\b(?=[0-9]*[a-f])(?=[a-f]*[0-9])[0-9a-f]{7,40}\b")
SEED = re.compile(r"(?<!-)\bseeds? \d+|--seed \d{3,}", re.IGNORECASE)
NAMED = re.compile(r"`((?:tests|tools|executive|trees|robots|kinematics)/[a-z0-9_./-]+)`")
"""Files and folders of the code in running text; names with capitals are to be put in by the reader."""
OF_THEIR_DAY = ("adr", "measured")
"""Decisions tell of their day; measurements are made by programs, and held by tests of these."""

READERS_WANT = {
    "how to run": ("docs/start/install.md", "docs/start/first-pick.md"),
    "how it works": ("docs/understand/architecture.md", "docs/understand/one-pick.md"),
    "how to add a skill": ("docs/extend/a-skill.md",),
    "the command line": ("docs/reference/cli.md", "docs/start/exit-codes.md"),
    "what was measured": ("docs/measured/index.md", "docs/measured/pick.md", "docs/measured/benchmarks.md"),
}


def pages():
    return [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted(DOCS.rglob("*.md"))]


def prose(page):
    """A page without its fenced blocks: what looks like a link there is none."""
    return FENCED.sub("", page.read_text("utf-8"))


def links(page):
    """Files that a page leads to, each with the heading, or None."""
    for path, heading in LINK.findall(prose(page)):
        if not path.startswith("http"):
            yield (page.parent / path).resolve() if path else page, heading or None


def headings(page):
    """Headings as they stand in addresses; the second one of the same words has "-1", and so on."""
    seen = {}
    for heading in re.findall(r"^#+ (.*)$", prose(page), re.MULTILINE):
        plain = LINK.sub("", heading)
        address = re.sub(r"[^\w\- ]", "", plain.lower()).replace(" ", "-")
        count = seen[address] = seen.get(address, -1) + 1
        yield f"{address}-{count}" if count else address


def reached(clicks):
    """Pages that are so many clicks from the README, or fewer."""
    found = {ROOT / "README.md"}
    for _ in range(clicks):
        found |= {target for page in found if page.suffix == ".md" for target, _ in links(page)}
    return found


def test_every_link_of_the_guides_leads_to_a_file_and_to_its_heading():
    broken = [
        f"{page.relative_to(ROOT)}: {target.name}#{heading or ''}"
        for page in pages()
        for target, heading in links(page)
        if not target.is_file() or (heading and heading not in headings(target))
    ]

    assert broken == []


@pytest.mark.parametrize("want", READERS_WANT)
def test_what_a_new_reader_wants_is_two_clicks_from_the_readme(want):
    assert [path for path in READERS_WANT[want] if ROOT / path not in reached(2)] == []


def test_every_page_is_three_clicks_from_the_readme():
    assert [str(page.relative_to(ROOT)) for page in pages() if page not in reached(3)] == []


def test_every_picture_is_shown_somewhere():
    shown = {target for page in pages() for target, _ in links(page)}

    assert [picture.name for picture in (DOCS / "pictures").iterdir() if picture not in shown] == []


def test_every_schema_is_told_of_somewhere():
    told = {target for page in pages() for target, _ in links(page)}

    assert [schema.name for schema in DOCS.rglob("*.schema.json") if schema not in told] == []


def of_today():
    return [page for page in pages() if page.relative_to(ROOT).parts[1:2] not in [(p,) for p in OF_THEIR_DAY]]


def test_no_page_names_a_commit():
    named = [
        f"{page.relative_to(ROOT)}: {found}"
        for page in of_today()
        for found in COMMIT.findall(page.read_text("utf-8"))
    ]

    assert named == []


def test_no_page_keys_what_it_tells_by_a_seed():
    keyed = [
        f"{page.relative_to(ROOT)}: {found}" for page in of_today() for found in SEED.findall(prose(page))
    ]

    assert keyed == []


@pytest.mark.parametrize("text", ["at 66e9d4c it was", "since 0edfbe8,", "11b929e"])
def test_a_commit_is_told_from_a_number_and_from_a_word(text):
    assert COMMIT.search(text)
    assert not COMMIT.search("1234567 defaced 2026-11-22 0.0012345")


def test_every_file_and_folder_that_a_page_names_is_there():
    gone = [
        f"{page.relative_to(ROOT)}: {name}"
        for page in of_today()
        for name in NAMED.findall(prose(page))
        if not (ROOT / name).exists()
    ]

    assert gone == []


def test_every_page_begins_with_its_one_title():
    wrong = [
        str(page.relative_to(ROOT))
        for page in pages()
        if not prose(page).startswith("# ") or len(re.findall(r"^# ", prose(page), re.MULTILINE)) != 1
    ]

    assert wrong == []


def test_file_names_in_the_product_and_its_tests_that_are_of_the_docs_are_there():
    sources = [
        path
        for floor in ("executive", "trees", "robots", "kinematics", "tools")
        for path in (ROOT / floor).rglob("*")
        if path.suffix in (".py", ".toml")
    ]
    named = re.compile(r"\bdocs/[\w./-]*\w\.(?:md|json|svg|png)\b")
    gone = [
        f"{path.relative_to(ROOT)}: {name}"
        for path in [*sources, ROOT / "Makefile", ROOT / "CHANGELOG.md"]
        for name in named.findall(path.read_text("utf-8"))
        if not (ROOT / name).exists()
    ]

    assert gone == []
