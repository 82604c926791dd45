"""The documentation builds without a warning, fits a phone, and its search finds concepts first."""

from __future__ import annotations

import json
import os
import re
from collections.abc import Iterator
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from threading import Thread
from typing import Any

import pytest
from browser import Browser

import flexel
from flexel.examples import gallery

GALLERY = {file.stem for file in Path(gallery.__path__[0]).glob("[a-z]*.py")}


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
    programs = [page for page in (html / "_generated" / "gallery").glob("*.html") if page.stem in GALLERY]
    assert len(programs) == len(GALLERY)
    for program in programs:  # each plays its motion
        assert "&lt;canvas id=&quot;picture&quot;" in program.read_text(encoding="utf-8"), program
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


# Loads pages, four at a time, in frames as wide as a phone, and answers with the width that each takes. The theme lets
# what is wide scroll within `.content`, so that the document itself is never wide.
WIDTHS = """(async (pages) => {
  const found = {}, missed = [], rest = pages.values();
  const width = (page) => Math.max(...[page.documentElement, ...page.querySelectorAll(".content")]
    .map((part) => part.scrollWidth));
  const look = async () => {
    for (const page of rest) {
      const frame = document.createElement("iframe");
      frame.style = "width: 390px; height: 844px; border: 0";
      const loaded = new Promise((done) => { frame.onload = done });
      frame.src = page;
      document.body.append(frame);
      await loaded;
      found[page] = width(frame.contentDocument);
      const wide = frame.contentDocument.createElement("p");
      wide.style = "width: 500px; height: 1em";
      (frame.contentDocument.querySelector("article") ?? frame.contentDocument.body).append(wide);
      if (width(frame.contentDocument) < 500) missed.push(page);
      frame.remove();
    }
  };
  await Promise.all([look(), look(), look(), look()]);
  return [found, missed];
})(%s)"""


@pytest.fixture
def address(html: Path) -> Iterator[str]:
    """Where the pages are served: a page may look into frames of its own server only."""

    class Quiet(SimpleHTTPRequestHandler):
        def log_message(self, format: str, *args: Any) -> None:
            """Say nothing."""

    with ThreadingHTTPServer(("127.0.0.1", 0), partial(Quiet, directory=html)) as server:
        thread = Thread(target=server.serve_forever)
        thread.start()
        yield f"http://127.0.0.1:{server.server_port}"
        server.shutdown()
        thread.join()


def test_no_page_is_wider_than_a_phone(html: Path, address: str, browser: Browser) -> None:
    """Tables, programs and formulas scroll by themselves; pictures shrink."""
    pages = sorted(f"/{page.relative_to(html).as_posix()}" for page in html.rglob("*.html"))
    browser.go(f"{address}/_static/file.png")
    found, missed = browser.value(WIDTHS % json.dumps(pages))
    assert sorted(found) == pages
    assert missed == []  # a paragraph that is too wide would be seen on every page
    assert {page: width for page, width in found.items() if width > 390} == {}
