"""The HTML page in a browser: it draws, asks for nothing, and its values are the quadratics of film.vtu.

Needs chromium (apt install chromium, or CHROMIUM with its path); without it these tests are skipped."""

import os
import shutil
import subprocess
from functools import cache
from itertools import product

import numpy as np
import pytest
import pyvista
from PIL import Image
from scipy import ndimage

import vtu_geometry
from oilwedge_run import SCENES, program

CHROMIUM = os.environ.get("CHROMIUM") or shutil.which("chromium") or shutil.which("google-chrome")
playwright = pytest.importorskip("playwright.sync_api")
pytestmark = pytest.mark.skipif(CHROMIUM is None, reason="no chromium on this machine")
ENGINE = "17_engine_main_bearing"
NAMES = ("02_flexpde_shell", "07_grooved_liner", ENGINE)
TELEPHONE = {"width": 390, "height": 844}
DESKTOP = {"width": 1200, "height": 1000}
POINTS = 1000


@pytest.fixture(scope="module")
def browser():
    with playwright.sync_playwright() as started:
        browser = started.chromium.launch(executable_path=CHROMIUM, args=["--no-sandbox"])
        yield browser
        browser.close()


@pytest.fixture(scope="module")
def report(tmp_path_factory):
    """Folder of a scene solved with --report, by its name; that of the engine has the pictures too."""

    @cache
    def one(name):
        folder = tmp_path_factory.mktemp("report")
        command = [program("OILWEDGE_BIN", "oilwedge"), "solve", str(SCENES / f"{name}.toml")]
        command += ["--out", str(folder), "--unrolled", "--report", *["--plot"] * (name == ENGINE)]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        return folder

    return one


@pytest.fixture
def opened(browser):
    """Opens the page of a folder: it is ready, and has asked for nothing and said nothing on the way."""
    contexts = []

    def one(folder, ready="yes", name="report.html", **how):
        contexts.append(browser.new_context(**how))
        page = contexts[-1].new_page()
        heard = []
        page.on("console", lambda message: heard.append(message.text))
        page.on("pageerror", lambda error: heard.append(str(error)))
        page.on("request", lambda request: heard.append(request.url))
        page.goto(f"file://{folder}/{name}")
        page.wait_for_selector(f"html[data-ready={ready}]", state="attached", timeout=20_000)
        assert heard == [f"file://{folder}/{name}"]
        return page

    yield one
    for context in contexts:
        context.close()


def assert_it_fits(page):
    """On a telephone, in both colour schemes."""
    for scheme in ("light", "dark"):
        page.emulate_media(color_scheme=scheme)
        assert page.evaluate("document.documentElement.scrollWidth") <= TELEPHONE["width"]


def assert_axe_has_no_finding(page, rules=None):
    axe = pytest.importorskip("axe_playwright_python.sync_playwright")
    found = axe.Axe().run(page, options={"runOnly": rules} if rules else None).response
    assert [(it["id"], it["nodes"][0]["html"]) for it in found["violations"]] == []
    assert len(found["passes"]) >= 1


def shapes(shares):
    a, b, c = shares
    return np.array([a * (2 * a - 1), b * (2 * b - 1), c * (2 * c - 1), 4 * a * b, 4 * b * c, 4 * c * a])


@pytest.mark.parametrize("name", NAMES)
def test_values_are_the_quadratics_of_the_file_and_fit_a_telephone(opened, report, name):
    """At random points, also in triangles at round rims: to 1e-6 of the range."""
    page = opened(report(name), viewport=TELEPHONE, color_scheme="dark")
    assert_it_fits(page)
    grid = pyvista.read(report(name) / "film.vtu")
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
    drawn = [name for name in grid.point_data.keys() if name in found[0]]
    assert {"pressure", "film_thickness", "viscosity"} <= set(drawn)
    for name in drawn:
        values = np.asarray(grid.point_data[name])
        wanted = np.einsum("ki,ki->k", weights, values[cells[chosen]])
        got = np.array([it[name] for it in found])
        assert np.abs(got - wanted).max() <= max(1e-6 * np.ptp(values), 1e-12 * np.abs(values).max()), name
    for name in grid.cell_data.keys():
        values = np.asarray(grid.cell_data[name])
        got = np.array([it[name] for it in found])
        assert got == pytest.approx(values[chosen], rel=1e-6), name


@pytest.mark.parametrize(("name", "scheme"), tuple(zip(NAMES, ("light", "dark", "light"))))
def test_fields_cursor_and_view_answer_and_axe_has_no_finding(opened, report, name, scheme):
    page = opened(report(name), viewport=DESKTOP, color_scheme=scheme, bypass_csp=True)
    assert_axe_has_no_finding(page)
    if name == ENGINE:
        # The other scheme has other colours and nothing else.
        page.emulate_media(color_scheme="dark")
        assert_axe_has_no_finding(page, ["color-contrast"])
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
    page.wait_for_function("(seen) => document.getElementById('view').toDataURL() != seen", arg=seen)


@pytest.mark.parametrize("name", (NAMES[0], ENGINE))
def test_without_a_script_all_figures_are_there(browser, report, name):
    with browser.new_context(java_script_enabled=False) as context:
        page = context.new_page()
        page.goto(f"file://{report(name)}/report.html")
        figures = page.query_selector_all("figure svg")
        assert len(figures) >= 5
        assert all(figure.is_visible() for figure in figures)


SWEEP = """[sweep]
speed = ["1000 rpm", "2000 rpm", "3000 rpm"]
"oil.barus.alpha" = ["0 1/Pa", "1e-6 1/Pa"]
eccentricity = { from = 0.2, to = 0.9, steps = 4 }
"""


@pytest.fixture(scope="module")
def studies(tmp_path_factory):
    """Folders of a sweep over three axes, of which some cases have no film, and of a convergence study."""
    folder = tmp_path_factory.mktemp("studies")
    scene = (SCENES / "01_plain_ring.toml").read_text().replace("../meshes", str(SCENES.parent / "meshes"))
    scene = scene.replace("[oil]", SWEEP + '\n[oil]\nbarus = { alpha = "1e-8 1/Pa" }')
    (folder / "scene.toml").write_text(scene)
    oilwedge = program("OILWEDGE_BIN", "oilwedge")
    for verb, more in (("sweep", []), ("converge", ["--max-seconds", "1"])):
        command = [oilwedge, verb, "scene.toml", "--out", verb, "--report", *more]
        subprocess.run(command, check=False, cwd=folder, stdout=subprocess.DEVNULL)
    return folder


@pytest.mark.parametrize(("verb", "ready"), (("sweep", "yes"), ("converge", "static")))
def test_studies_fit_a_telephone_and_axe_has_no_finding(opened, studies, verb, ready):
    name = f"{verb}.html"
    page = opened(studies / verb, ready, name, viewport=TELEPHONE, color_scheme="light")
    assert_it_fits(page)
    page = opened(studies / verb, ready, name, viewport=TELEPHONE, color_scheme="dark", bypass_csp=True)
    assert_axe_has_no_finding(page)
    page.emulate_media(color_scheme="light")
    assert_axe_has_no_finding(page, ["color-contrast"])


def test_a_sweep_shows_the_chosen_quantity_over_the_chosen_axes(opened, studies):
    page = opened(studies / "sweep", name="sweep.html", viewport=DESKTOP)
    curves, cells, readout = ("() => document.getElementById('%s').innerHTML" % it for it in ("curves", "cells", "readout"))
    assert page.evaluate(curves).count('class="curve') == 2
    seen = page.evaluate(curves)
    page.select_option("#quantity", label="friction power")
    assert page.evaluate(curves) != seen and "friction power" in page.evaluate(curves)
    page.select_option("#axis-along", label="speed")
    page.select_option("#axis-across", label="eccentricity")
    assert page.evaluate(curves).count('class="curve') == 4
    assert page.evaluate(cells).count('class="cell"') == 12
    page.focus("#cells")
    for key in ("ArrowRight", "ArrowUp"):
        page.keyboard.press(key)
    assert "speed 2000" in page.evaluate(readout) and "friction power" in page.evaluate(readout)
    page.select_option("#axis-across", label="none")
    assert page.evaluate(curves).count('class="curve') == 1
    assert not page.is_visible("#cells")
    # The cases without a film, and why.
    page.select_option("#axis-across", label="oil.barus.alpha")
    assert page.evaluate(cells).count('class="cell empty"') > 0
    page.check("#logarithmic")
    assert page.evaluate(curves).count('class="curve') == 2
    page.focus("#cells")
    for key in ("ArrowUp", "ArrowRight", "ArrowRight"):
        page.keyboard.press(key)
    page.select_option("#fixed-2", index=3)
    assert "no solution" in page.evaluate(readout) and "no value" in page.evaluate(readout)


LETTERS = """() => [...document.querySelectorAll('text')].map((it) => {
  const box = it.getBoundingClientRect();
  return [box.left, box.top, box.right, box.bottom];
})"""


@pytest.mark.parametrize("name", ("pressure", "film_fraction", "error_indicator", "mesh", "section", "profiles"))
def test_pictures_are_the_same_in_the_browser(browser, report, name, tmp_path):
    """The PNG is that of resvg, at 300 dots per inch. Letters are left out, for their typefaces differ; a dot may be
    one dot away."""
    plotted = report(ENGINE) / "plot"
    dots = np.asarray(Image.open(plotted / f"{name}.png").convert("RGB"), dtype=float) / 255
    height, width = dots.shape[:2]
    scale = 300 / 96
    size = {"width": int(width / scale) + 2, "height": int(height / scale) + 2}
    with browser.new_context(viewport=size, device_scale_factor=scale) as context:
        page = context.new_page()
        page.goto(f"file://{plotted}/{name}.svg")
        page.screenshot(path=tmp_path / "seen.png")
        letters = page.evaluate(LETTERS)
    seen = np.asarray(Image.open(tmp_path / "seen.png").convert("RGB"), dtype=float)[:height, :width] / 255
    assert seen.shape == dots.shape
    apart = np.abs(seen - dots).max(axis=2)
    rows, columns = np.nonzero(apart)
    for i, j in product((-1, 0, 1), repeat=2):
        moved = seen[(rows - i) % height, (columns - j) % width]
        apart[rows, columns] = np.minimum(apart[rows, columns], np.abs(moved - dots[rows, columns]).max(axis=1))
    are_letters = np.zeros(apart.shape, dtype=bool)
    for left, top, right, bottom in letters:
        room = 2 + 0.15 * max(right - left, bottom - top)
        rows, columns = ([max(0, int(scale * (a - room))), int(scale * (b + room))] for a, b in ((top, bottom), (left, right)))
        are_letters[slice(*rows), slice(*columns)] = True
    assert are_letters.mean() < 0.35
    apart[are_letters] = 0
    assert apart.mean() < 0.015, apart.mean()
    # Lines are smoothed differently; nothing thicker than three dots may differ.
    patches, _ = ndimage.label(ndimage.binary_opening(apart > 0.2, np.ones((3, 3))))
    areas = np.bincount(patches.ravel())[1:] * (25.4 / 300) ** 2
    assert areas.max(initial=0) < 0.1, f"{areas.max()} mm2"
