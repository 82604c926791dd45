"""The documentation builds without a warning, fits a phone, and its search finds concepts first."""

from __future__ import annotations

import json
import os
import re
from pathlib import Path

import pytest
from browser import Browser

import flexel


@pytest.fixture(scope="module")
def html() -> Path:
    """The pages that `make docs` built, a warning being an error."""
    built = os.environ.get("FLEXEL_DOCS", "")
    if not built:
        pytest.skip("the pages are built by `make docs`; then FLEXEL_DOCS=docs/_build make test tests them")
    assert (Path(built) / "index.html").is_file(), f"FLEXEL_DOCS: there are no pages in {built}"
    return Path(built)


def test_pages_hold_what_they_should(html: Path) -> None:
    page = (html / "_generated" / "elements" / "wheel.html").read_text(encoding="utf-8")
    assert "longitudinal" in page and "against the definition" in page
    report = (html / "report-latest.html").read_text(encoding="utf-8")
    assert "Published numbers" in report and "<td>wheel</td>" in report
    formulas = (html / "theory.html").read_text(encoding="utf-8")
    assert formulas.count("<math") > 50 and 'class="accented">q\u0308' in formulas
    assert not re.search(r"<(script|link)[^>]*(src|href)=.https?://", formulas)  # nothing from a network
    classic = (html / "_generated" / "gallery" / "four_bar.html").read_text(encoding="utf-8")
    assert "sphx_glr_four_bar_001.png" in classic and "the rocker swings between" in classic
    assert 'href="report-latest.html"' in (html / "report.html").read_text(encoding="utf-8")


def test_all_public_names_and_methods_are_in_the_reference(html: Path) -> None:
    pages = (html / "_generated" / "api").glob("*.html")
    described = {
        name for page in pages for name in re.findall(r'id="flexel\.([\w.]+)"', page.read_text("utf-8"))
    }
    methods = {f"{owner}.{name}" for owner in ("Model", "System") for name in dir(getattr(flexel, owner))}
    wanted = {*flexel._HOMES, *(method for method in methods if "._" not in method)}
    assert wanted - described == set()


@pytest.mark.parametrize(
    ("sought", "first"),
    [
        ("degree of freedom", "concepts#term-degree-of-freedom"),
        ("slip", "concepts#term-slip"),
        ("tolerance", "concepts#term-tolerance"),
        ("beam", "concepts#term-beam"),
        ("rope", "concepts#term-rope"),
        ("kinematic coordinate", "concepts#term-kinematic-coordinate"),
        ("choice of integrator", "concepts#choice-of-integrator-and-tolerance"),
        ("simulate", "_generated/api/systems-states-and-motions#flexel.System.simulate"),
    ],
)
def test_the_search_finds_concepts_first(html: Path, browser: Browser, sought: str, first: str) -> None:
    """And a name itself before pages that mention it, and guides before the gallery and the rest of the reference."""
    browser.go((html / "search.html").as_uri() + "?q=none")
    browser.wait("typeof Search !== 'undefined' && Search.hasIndex()")
    asked = (
        f"Search._performSearch(...Search._parseQuery({json.dumps(sought)})).reverse()"
        ".map(entry => entry[0] + entry[2])"
    )
    found = [address.removeprefix("./") for address in browser.value(asked)]
    assert found[0] == first
    guides = [i for i, address in enumerate(found) if re.fullmatch(r"start|vehicles|cranes|joints", address)]
    gallery = [i for i, address in enumerate(found) if "_generated/gallery" in address]
    assert not (guides and gallery) or max(guides) < min(gallery)


def test_no_page_is_wider_than_a_phone(html: Path, browser: Browser) -> None:
    """Tables, programs and formulas scroll by themselves; pictures shrink."""
    browser.resize(390, 844, phone=True)
    wide = {}
    for page in sorted(html.rglob("*.html")):
        browser.go(page.as_uri())
        width = browser.value("document.documentElement.scrollWidth")
        if width > 390:
            wide[page.name] = width
    assert wide == {}
