"""The book in a browser: pages open, find words, and ask for nothing outside.

Needs mdBook and chromium; without them these tests are skipped."""

import os
import shutil
import subprocess

import pytest

from oilwedge_run import REPOSITORY

CHROMIUM = os.environ.get("CHROMIUM") or shutil.which("chromium") or shutil.which("google-chrome")
playwright = pytest.importorskip("playwright.sync_api")
pytestmark = [
    pytest.mark.full,
    pytest.mark.skipif(CHROMIUM is None, reason="no chromium on this machine"),
    pytest.mark.skipif(shutil.which("mdbook") is None, reason="mdBook is not installed"),
]
PAGES = ("index.html", "tutorial.html", "gallery.html", "theory/notation.html", "reference/scene.html", "howto/clusters.html")


def test_pages_ask_for_nothing_outside(tmp_path):
    subprocess.run(["mdbook", "build", str(REPOSITORY / "docs"), "--dest-dir", str(tmp_path)], check=True)
    asked, said = [], []
    with playwright.sync_playwright() as started:
        browser = started.chromium.launch(executable_path=CHROMIUM, args=["--no-sandbox"])
        page = browser.new_page()
        page.on("request", lambda request: asked.append(request.url))
        page.on("pageerror", lambda error: said.append(str(error)))
        for name in PAGES:
            page.goto(f"file://{tmp_path}/{name}", wait_until="load")
            broken = page.evaluate("[...document.images].filter(it => !it.naturalWidth).map(it => it.src)")
            assert broken == [], name
        assert page.locator("main h1").first.inner_text() == "A sweep on many machines"
        browser.close()
    assert len(asked) > len(PAGES)
    assert [url for url in asked if not url.startswith(("file://", "data:"))] == []
    assert said == []
