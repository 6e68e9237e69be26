"""The numbers that the Rust solver reports with their error bars: those of the film in cubic triangles.

Value: `cubic.py` on the same mesh with scikit-fem's rule of degree 8, whose points are those of the program's, so
nothing but round-off and the program's iterations stands between the two. Bar: the difference of the cubic and the
quadratic film of scikit-fem, which enters it, and an answer of scikit-fem on cells a quarter as wide.
"""

from functools import cache

import numpy as np
import pytest

from cubic import solve_cubic
from film import rule_of_degree, solve_film
from oilwedge_run import SCENES, quantity, solve
from scene_file import read_scene, write_variant

REYNOLDS = {"cavitation": {"model": "reynolds", "pressure": "0 bar"}}
BARUS = {"barus": {"alpha": "2.5e-8 1/Pa"}}
CONSTANT = {"barus": None}
LINEAR = {
    "plain ring": ("01_plain_ring", {}),
    "plain ring, Barus": ("01_plain_ring", BARUS),
    "shell": ("02_flexpde_shell", {}),
    "shell, constant viscosity": ("02_flexpde_shell", CONSTANT),
    "shell at rest": ("03_hydrostatic_shell", {}),
    "shell, straight cells": ("02_flexpde_shell", {"mesh": "flexpde_shell_straight.msh", "hole_keys": False}),
    "shell, straight cells, exact rim": ("02_flexpde_shell", {"mesh": "flexpde_shell_straight.msh"}),
    "ring": ("04_flexpde_ring", {}),
    "ring, constant viscosity": ("04_flexpde_ring", CONSTANT),
    "liner on the cylinder": ("07_grooved_liner", {}),
    "liner, constant viscosity": ("07_grooved_liner", CONSTANT),
    "liner, holes by their closed curves": ("07_grooved_liner", {"hole_keys": False}),
    "study size": ("08_flexpde_study_size", {}),
}
BROKEN = {
    "plain ring, broken": ("01_plain_ring", REYNOLDS),
    "plain ring, Barus, broken": ("01_plain_ring", REYNOLDS | BARUS),
    "shell, broken": ("02_flexpde_shell", REYNOLDS),
    "shell, meshed hole, broken": ("02_flexpde_shell", REYNOLDS | {"mesh": "flexpde_shell_meshed_hole.msh"}),
    "ring, broken below the ends": (
        "04_flexpde_ring", {"cavitation": {"model": "reynolds", "pressure": "-0.5 bar"}}
    ),
    "liner, broken": ("07_grooved_liner", REYNOLDS),
}  # fmt: skip
CASES = LINEAR | BROKEN
# The cases whose bars may follow the law of smooth films: no cavity, and constant viscosity.
SMOOTH = ("plain ring", "shell, constant viscosity", "ring, constant viscosity", "liner, constant viscosity")
# The cases whose film has re-entrant corners, those of a groove, which count in a bar by themselves.
CORNERS = "liner"


@pytest.fixture(scope="module")
def solved(tmp_path_factory):
    """(scene, result, grid of the Rust solver, cubic film) by name of the case; each is solved once."""

    @cache
    def one(name):
        source, changes = CASES[name]
        folder = tmp_path_factory.mktemp("case")
        path = write_variant(SCENES / f"{source}.toml", folder / "scene.toml", **changes)
        result, grid = solve(path, unrolled=True)
        scene = read_scene(path)
        return scene, result, grid, solve_cubic(scene)

    return one


def bar(result, name):
    return result["quantities"][name]["error"]


@pytest.mark.parametrize("name", CASES)
def test_reported_numbers_are_those_of_the_cubic_film(name, solved):
    """Linear films to 1e-10; the program solves the film that breaks by iteration, to 1e-9."""
    _, result, _, cubic = solved(name)
    tolerance = 1e-9 if name in BROKEN else 1e-10
    load = np.hypot(*cubic.load)
    turn = np.exp(1j * np.radians(quantity(result, "load_angle"))) / complex(*cubic.load)
    print(
        f"load {quantity(result, 'load') / load - 1:+.1e}, angle {np.angle(turn):+.1e} rad,"
        f" integral {(quantity(result, 'pressure_integral') - cubic.pressure_integral) / load:+.1e} of the load,"
        f" pressure_max {quantity(result, 'pressure_max') / cubic.pressure_max - 1:+.1e}"
    )
    assert quantity(result, "load") == pytest.approx(load, rel=tolerance)
    assert abs(np.angle(turn)) < tolerance
    # The integral of a full Sommerfeld ring is zero but for the mesh, so it is held against the load.
    assert quantity(result, "pressure_integral") == pytest.approx(cubic.pressure_integral, abs=tolerance * load)
    assert quantity(result, "pressure_max") == pytest.approx(cubic.pressure_max, rel=tolerance)


@pytest.mark.parametrize("name", CASES)
def test_the_bar_holds_the_difference_of_the_two_films(name, solved):
    """`discretisation = (1 + 100/n) (0.3 |eta| + 0.05 S + corners)` (0.4 across the load), n the number of triangles,
    with S the sum of the |eta_K|, so S >= |eta|.

    eta is computed here, with one rule for both films. Where there are neither corners nor a cavity, the sum
    of the indicator, the greater |eta_K| of along and across, is no less than S: a limit from above."""
    scene, result, grid, cubic = solved(name)
    quadratic = solve_film(scene, rule_of_degree(8))
    eta = cubic.load - [quadratic.load_x, quadratic.load_y]
    unit = cubic.load / np.hypot(*cubic.load)
    along, across = abs(eta @ unit), abs(eta @ [-unit[1], unit[0]])
    parts = {key: result["quantities"][key]["error_parts"] for key in ("load", "load_angle")}
    widened = 1 + 100 / result["mesh"]["cells"]
    found = [
        parts["load"]["discretisation"] / widened,
        np.radians(parts["load_angle"]["discretisation"]) * np.hypot(*cubic.load) / widened,
    ]
    print(f"eta: {along:.3e} {across:.3e} N, bars {found[0]:.3e} {found[1]:.3e} N")
    rounding = 1e-9 * np.hypot(*cubic.load)
    if name in SMOOTH:
        # `(|eta| + 0.5 S') sqrt(S'/W)` away from corners, whose part of S counts more.
        law = [size * np.sqrt(size / np.hypot(*cubic.load)) for size in (along, across)]
        assert found[0] >= min(0.35 * along, law[0]) - rounding
        assert found[1] >= min(0.45 * across, law[1]) - rounding
    else:
        assert bar(result, "load") >= 0.3 * along
        assert found[0] >= 0.35 * along - rounding
        assert found[1] >= 0.45 * across - rounding
    if name in LINEAR and not name.startswith(CORNERS):
        most = 0.05 * np.sum(grid.cell_data["error_indicator"])
        assert found[0] <= 0.3 * along + most + rounding
        assert found[1] <= 0.4 * across + most + rounding


@pytest.mark.parametrize("name", ["shell", "plain ring, broken", "liner, constant viscosity"])
def test_the_bar_holds_the_answer_of_a_finer_mesh(name, solved):
    """Quadratic triangles on a mesh refined twice."""
    scene, result, _, _ = solved(name)
    fine = solve_film(scene, rule_of_degree(8), refinements=2)
    load = np.hypot(fine.load_x, fine.load_y)
    turn = np.exp(1j * np.radians(quantity(result, "load_angle"))) / complex(fine.load_x, fine.load_y)
    off, turned = quantity(result, "load") - load, np.degrees(np.angle(turn))
    bars = [bar(result, key) for key in ("load", "load_angle")]
    print(f"load off by {off:+.2e} N, bar {bars[0]:.2e}; angle off by {turned:+.2e} deg, bar {bars[1]:.2e}")
    assert abs(off) < bars[0] < 5e-3 * load
    assert abs(turned) < bars[1]
