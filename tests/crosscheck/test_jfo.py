"""`jfo_structured.py` against closed forms and published numbers, and the Rust solver against it.

References and their sources: tests/data/journal_bearings.json.
"""

import json
import tomllib

import numpy as np
import pytest

import jfo_structured
from oilwedge_run import REPOSITORY, SCENES, quantity, solve
from scene_file import si

DATA = json.loads((REPOSITORY / "tests/data/journal_bearings.json").read_text())
GROOVED = DATA["jfo_groove_bearing"]
SETUP = GROOVED["setup"]
BEARING = jfo_structured.Bearing(
    radius=SETUP["d"] / 2,
    length=SETUP["l"],
    clearance=SETUP["c"],
    eccentricity=SETUP["eps"],
    viscosity=SETUP["mu"],
    speed=SETUP["rpm"] * np.pi / 30,
)
FLOW_UNIT = BEARING.speed * BEARING.radius**2 * BEARING.clearance / 12


def structured(case, columns, rows):
    """The film of one supply on a grid; 240 x 32 and its multiples have lines on the edges of the grooves."""
    data, pressure = GROOVED[case], SETUP["p_groove"]
    if case == "hole":
        radius = data["radius_over_R"] * BEARING.radius
        return jfo_structured.solve(BEARING.with_hole(columns, rows, data["angle_rad"], radius, pressure))
    start, end = np.radians([90 - SETUP["groove_arc_deg"] / 2, 90 + SETUP["groove_arc_deg"] / 2])
    film = BEARING.with_groove(columns, rows, start, end, data["groove_axial_m"], pressure)
    return jfo_structured.solve(film)


def supply_flow(film):
    return film.inflow[film.film.given > 0].sum() / FLOW_UNIT


def pocketed_pad(cells):
    """Fowell's pad with a pocket: (film, its reference)."""
    case = DATA["fowell_2007_pocket_slider"]
    setup = case["setup"]
    start, end = setup["pocket_start"], setup["pocket_start"] + setup["pocket_length"]

    def thickness(x):
        pocket = np.where((x > start) & (x < end), setup["pocket_depth"], 0.0)
        return setup["h_max"] + (setup["h_min"] - setup["h_max"]) * x / setup["L"] + pocket

    given = np.full((cells + 1, 1), np.nan)
    given[[0, -1]] = setup["p_amb"]
    x = np.linspace(0, setup["L"], cells + 1)
    film = jfo_structured.Film(x, np.zeros(1), None, thickness, setup["U"], setup["mu"], given)
    return jfo_structured.solve(film), case["results"]


def test_pocketed_pad_has_the_closed_form():
    """Conductances are those of the middles of cells: errors of order 2, here 1e-8 of the flow. The front is found to a
    cell."""
    film, expected = pocketed_pad(1000)
    x, p = film.film.x, film.pressure[:, 0]
    assert film.inflow[0, 0] == pytest.approx(expected["flow_per_width_m2_s"], rel=1e-8)
    assert film.inflow.sum() == pytest.approx(0, abs=1e-12 * film.inflow[0, 0])
    cavity = x[film.theta[:, 0] < 1]
    assert cavity.min() == pytest.approx(0.002, abs=1e-5 + 1e-9)
    assert cavity.max() == pytest.approx(expected["reformation_x_m"], abs=1e-5)
    assert np.interp(0.005, x, p) == pytest.approx(expected["p_pocket_exit_Pa"], rel=1e-7)
    assert np.interp(0.001, x, p) == pytest.approx(expected["p_at_x_1mm_Pa"], rel=1e-7)
    load = np.trapezoid(p, x) - 1e5 * 0.01
    assert load == pytest.approx(expected["load_N_per_m_gauge"], rel=1e-5)


def test_starved_wedge_has_the_closed_form():
    """h = 2 - x, 0.6 of the gap filled at x = 0: full from h = 1.5 on, where the flow U h theta/2 = 0.6 U begins to be
    pressed; p = 6 mu U (1/h - 0.6/h^2 - 0.4), its integral 6 mu U (ln 1.5 - 0.4)."""
    for cells in (200, 400):
        given = np.full((cells + 1, 1), np.nan)
        given[-1] = 0.0
        x = np.linspace(0, 1, cells + 1)
        strip = jfo_structured.Film(x, np.zeros(1), None, lambda x: 2 - x, 1.0, 1.0, given, inlet=0.6)
        film = jfo_structured.solve(strip)
        theta, p = film.theta[:, 0], film.pressure[:, 0]
        front = x[theta < 1].max()
        assert front == pytest.approx(0.5, abs=1.5 / cells)
        cavity = (x > 0) & (x < front)
        assert theta[cavity] * (2 - x[cavity]) == pytest.approx(1.2, rel=2e-2)
        assert np.trapezoid(p, x) == pytest.approx(6 * (np.log(1.5) - 0.4), rel=8 / cells)
        assert film.inflow[-1, 0] == pytest.approx(-0.6, rel=1e-9)


@pytest.mark.parametrize(("case", "tolerance"), [("groove", 7e-4), ("short_groove", 1e-3), ("hole", 7e-4)])
def test_bearings_on_a_moderate_grid(case, tolerance):
    """240 x 32 cells; the limits come from grids up to four times finer."""
    film, expected = structured(case, 240, 32), GROOVED[case]
    load = film.load(BEARING.radius)
    assert np.hypot(*load) == pytest.approx(expected["F"], rel=tolerance)
    assert load[0] == pytest.approx(expected["W_X0"], abs=2 * tolerance * expected["F"])
    assert load[1] == pytest.approx(expected["W_X90"], abs=2 * tolerance * expected["F"])
    assert film.pressure.max() == pytest.approx(expected["p_max"], rel=tolerance)
    assert supply_flow(film) == pytest.approx(expected["supply_flow"], rel=7e-3)
    assert film.inflow.sum() == pytest.approx(0, abs=1e-11 * FLOW_UNIT)
    assert film.theta.min() > 0 and film.theta.max() <= 1 + 1e-11


def scene(name):
    return tomllib.loads((SCENES / f"{name}.toml").read_text())


def bearing(table, eccentricity):
    dimensions = [si(table["bearing"][key]) for key in ("diameter", "length", "clearance")]
    viscosity, speed = si(table["oil"]["viscosity"]), si(table["journal"]["speed"])
    return jfo_structured.Bearing(dimensions[0] / 2, *dimensions[1:], eccentricity, viscosity, speed)


def test_starved_pad():
    """Scene 14; its reference (`jfo_starved_arc`) comes from grids up to 768 x 128."""
    table, expected = scene("14_starved_pad"), DATA["jfo_starved_arc"]["results"]
    thinnest = si(table["journal"]["min_film_angle"])
    arc = table["bearing"]["arc"]
    start, end = (si(arc[key]) - thinnest for key in ("from", "to"))
    liner = bearing(table, table["journal"]["eccentricity"])
    film = jfo_structured.solve(liner.starved_arc(192, 32, start, end, arc["inlet_fraction"]))
    load = complex(*film.load(liner.radius)) * np.exp(1j * thinnest)
    assert load.real == pytest.approx(expected["W_x"], abs=5e-4 * expected["F"])
    assert load.imag == pytest.approx(expected["W_y"], abs=5e-4 * expected["F"])
    assert film.pressure.max() == pytest.approx(expected["p_max"], rel=2e-4)
    result, _ = solve(SCENES / "14_starved_pad.toml", unrolled=True)
    for key, name in (("load_x", "W_x"), ("load_y", "W_y")):
        assert quantity(result, key) == pytest.approx(expected[name], abs=5e-4 * expected["F"])
    assert quantity(result, "pressure_max") == pytest.approx(expected["p_max"], rel=5e-4)


def test_engine_bearing_carries_its_load():
    """Scene 17: at the position that the program finds, the film of the structured code carries the load. Barus'
    pressure by the reduced one, p = -ln(1 - alpha q)/alpha."""
    table = scene("17_engine_main_bearing")
    result, _ = solve(SCENES / "17_engine_main_bearing.toml", unrolled=True)
    liner = bearing(table, quantity(result, "eccentricity"))
    thinnest = np.radians(quantity(result, "min_film_angle"))
    alpha, feed = si(table["oil"]["barus"]["alpha"]), table["feed"][0]
    start, end = (si(feed["groove"][key]) - thinnest for key in ("from", "to"))
    half = si(feed["groove"]["width"]) / 2
    supply = (1 - np.exp(-alpha * si(feed["pressure"]))) / alpha
    across = np.append(np.linspace(0, half, 6, endpoint=False), np.linspace(half, liner.length / 2, 35))
    around = np.append(
        np.linspace(start, end, 140, endpoint=False), np.linspace(end, start + 2 * np.pi, 220, endpoint=False)
    )
    given = np.full((len(around), len(across)), np.nan)
    given[:, -1] = 0.0
    given[np.ix_(around < end + 1e-9, across < half + 1e-9)] = supply
    x, surface = liner.radius * around, liner.speed * liner.radius
    turn = 2 * np.pi * liner.radius
    film = jfo_structured.Film(x, across, turn, liner.thickness, surface, liner.viscosity, given)
    film = jfo_structured.solve(film)
    film.pressure = -np.log(1 - alpha * film.pressure) / alpha
    load = complex(*film.load(liner.radius)) * np.exp(1j * thinnest)
    force = si(table["load"]["force"])
    assert load.real == pytest.approx(0, abs=1e-3 * force)
    assert load.imag == pytest.approx(-force, rel=1e-3)
    assert film.pressure.max() == pytest.approx(quantity(result, "pressure_max"), rel=1e-3)
    flow = 2 * film.inflow[film.film.given > 0].sum()
    assert flow == pytest.approx(quantity(result, "feed_flow.groove"), rel=5e-3)
    assert result["balances"]["force"] < 1e-10
