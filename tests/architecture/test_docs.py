"""Guides lead somewhere, and all of them are found from the README."""

import re
from pathlib import Path

ROOT = Path(__file__).parents[2]
LINK = re.compile(r"\]\(([^)\s#]*)(?:#([^)\s]*))?\)")


def pages():
    return [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]


def links(page):
    """Files that a page leads to, each with the heading, or None."""
    for path, heading in LINK.findall(page.read_text("utf-8")):
        if not path.startswith("http"):
            yield (page.parent / path).resolve() if path else page, heading or None


def headings(page):
    """Headings as they stand in addresses."""
    for heading in re.findall(r"^#+ (.*)$", page.read_text("utf-8"), re.MULTILINE):
        yield re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")


def test_every_link_of_the_guides_leads_to_a_file_and_to_its_heading():
    broken = [
        f"{page.relative_to(ROOT)}: {target.name}#{heading or ''}"
        for page in pages()
        for target, heading in links(page)
        if not target.exists() or (heading and heading not in headings(target))
    ]

    assert broken == []


def test_every_guide_is_found_from_the_readme():
    found, left = set(), [ROOT / "README.md"]
    while left:
        page = left.pop()
        if page in found:
            continue
        found.add(page)
        for target, _ in links(page):
            left += target.glob("*.md") if target.is_dir() else [target] if target.suffix == ".md" else []

    assert [page.name for page in pages() if page not in found] == []


def test_every_picture_is_shown_somewhere():
    shown = {target for page in pages() for target, _ in links(page)}

    assert [picture.name for picture in (ROOT / "docs" / "pictures").iterdir() if picture not in shown] == []
