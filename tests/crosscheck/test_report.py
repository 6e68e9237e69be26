"""The HTML page in a browser: it draws, asks for nothing, and its values are the quadratics of film.vtu.

Needs chromium (apt install chromium, or CHROMIUM with its path); without it these tests are skipped."""

import os
import shutil
import subprocess

import numpy as np
import pytest
import pyvista

import vtu_geometry
from oilwedge_run import SCENES, program

CHROMIUM = os.environ.get("CHROMIUM") or shutil.which("chromium") or shutil.which("google-chrome")
playwright = pytest.importorskip("playwright.sync_api")
pytestmark = pytest.mark.skipif(CHROMIUM is None, reason="no chromium on this machine")
NAMES = ("02_flexpde_shell", "07_grooved_liner", "13_grooved_ring", "17_engine_main_bearing")
POINTS = 1000


@pytest.fixture(scope="module")
def browser():
    with playwright.sync_playwright() as started:
        browser = started.chromium.launch(executable_path=CHROMIUM, args=["--no-sandbox"])
        yield browser
        browser.close()


@pytest.fixture(scope="module", params=NAMES)
def report(request, tmp_path_factory):
    """Folder of a scene solved with --report."""
    folder = tmp_path_factory.mktemp("report")
    command = [program("OILWEDGE_BIN", "oilwedge"), "solve", str(SCENES / f"{request.param}.toml")]
    command += ["--out", str(folder), "--unrolled", "--report"]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    return folder


def opened(browser, folder, **how):
    """The page, ready, and what it said and asked for on the way."""
    page = browser.new_context(**how).new_page()
    heard = []
    page.on("console", lambda message: heard.append(message.text))
    page.on("pageerror", lambda error: heard.append(str(error)))
    page.on("request", lambda request: heard.append(request.url))
    page.goto(f"file://{folder}/report.html")
    page.wait_for_selector("html[data-ready=yes]", state="attached", timeout=20_000)
    return page, [it for it in heard if it != f"file://{folder}/report.html"]


def shapes(shares):
    a, b, c = shares
    return np.array([a * (2 * a - 1), b * (2 * b - 1), c * (2 * c - 1), 4 * a * b, 4 * b * c, 4 * c * a])


def test_values_are_the_quadratics_of_the_file(browser, report):
    """At random points, also in triangles at round rims: to 1e-6 of the range."""
    page, heard = opened(browser, report)
    assert heard == []
    grid = pyvista.read(report / "film.vtu")
    cells = vtu_geometry.cells(grid)
    nodes = np.asarray(grid.points)[cells][:, :, :2]
    radius = page.evaluate("JSON.parse(document.getElementById('data').textContent).radius")
    random = np.random.default_rng(1)
    bulging = np.flatnonzero(vtu_geometry.bulge(nodes).max(axis=1) > 1e-9)
    chosen = random.integers(0, len(cells), POINTS)
    if len(bulging):
        chosen[: POINTS // 5] = random.choice(bulging, POINTS // 5)
    shares = random.dirichlet([1.0, 1.0, 1.0], POINTS) * 0.98 + 0.02 / 3
    weights = np.array([shapes(share) for share in shares])
    places = np.einsum("ki,kid->kd", weights, nodes[chosen])
    asked = [[float(np.degrees(x / radius)), float(1e3 * z)] for x, z in places]
    found = page.evaluate("(points) => points.map(([a, z]) => oilwedge.at(a, z))", asked)
    assert all(found)
    for name in grid.point_data.keys():
        values = np.asarray(grid.point_data[name])
        wanted = np.einsum("ki,ki->k", weights, values[cells[chosen]])
        got = np.array([it[name] for it in found])
        assert np.abs(got - wanted).max() <= max(1e-6 * np.ptp(values), 1e-12 * np.abs(values).max()), name
    for name in grid.cell_data.keys():
        values = np.asarray(grid.cell_data[name])
        got = np.array([it[name] for it in found])
        assert got == pytest.approx(values[chosen], rel=1e-6), name


@pytest.mark.parametrize("how", ({"color_scheme": "light"}, {"color_scheme": "dark"}))
def test_the_page_fits_a_telephone(browser, report, how):
    page, heard = opened(browser, report, viewport={"width": 390, "height": 844}, **how)
    assert heard == []
    assert page.evaluate("document.documentElement.scrollWidth") <= 390


def test_fields_cursor_and_view_answer(browser, report):
    page, _ = opened(browser, report, viewport={"width": 1200, "height": 1000})
    picture = "() => document.getElementById('{}').toDataURL().length"
    before = page.evaluate(picture.format("field"))
    for field in page.query_selector_all("input[name=field]"):
        field.check()
    page.check("input[name=field][value=film_thickness]")
    assert page.evaluate(picture.format("field")) != before
    told = page.text_content("#readout")
    page.focus("#map")
    page.keyboard.press("Shift+ArrowLeft")
    assert page.text_content("#readout") != told
    told = page.text_content("#readout")
    page.hover("#map", position={"x": 300, "y": 40})
    assert page.text_content("#readout") != told
    seen = page.evaluate("() => document.getElementById('view').toDataURL()")
    page.focus("#view")
    page.keyboard.press("ArrowRight")
    page.wait_for_timeout(500)
    assert page.evaluate("() => document.getElementById('view').toDataURL()") != seen


def test_without_a_script_all_figures_are_there(browser, report):
    page = browser.new_context(java_script_enabled=False).new_page()
    page.goto(f"file://{report}/report.html")
    figures = page.query_selector_all("figure svg")
    assert len(figures) >= 5
    assert all(figure.is_visible() for figure in figures)


@pytest.mark.parametrize("scheme", ("light", "dark"))
def test_axe_has_no_finding(browser, report, scheme):
    axe = pytest.importorskip("axe_playwright_python.sync_playwright")
    page, _ = opened(browser, report, bypass_csp=True, color_scheme=scheme)
    found = axe.Axe().run(page).response["violations"]
    assert [(it["id"], it["nodes"][0]["html"]) for it in found] == []
