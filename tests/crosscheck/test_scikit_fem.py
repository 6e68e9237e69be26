"""The quadratic film of the Rust solver, reported without error bars, against `film.py` on the same mesh with the same
quadrature rule.

Both are the same discrete problem, so they agree to round-off: 1e-9 allows for the condition
number of the matrix. `-s` or `-rP` shows what the rule itself costs.
"""

import numpy as np
import pytest
from scipy.spatial import cKDTree

from film import rule_of_degree, solve_film
from oilwedge_run import SCENES, crosscheck_data, quantity, solve
from scene_file import read_scene, write_variant

PRINTED = {"barus": {"alpha": "2.5e-8 1/Pa", "form": "as-printed"}}
CONSTANT = {"barus": None}
CASES = {
    "plain ring": ("01_plain_ring", {}),
    "shell": ("02_flexpde_shell", {}),
    "shell, constant viscosity": ("02_flexpde_shell", CONSTANT),
    "shell, as printed": ("06_flexpde_as_printed", {}),
    "shell at rest": ("03_hydrostatic_shell", {}),
    "shell, straight cells": (
        "02_flexpde_shell", {"mesh": "flexpde_shell_straight.msh", "hole_keys": False}
    ),
    "shell, straight cells, exact rim": (
        "02_flexpde_shell", {"mesh": "flexpde_shell_straight.msh"}
    ),
    "shell, meshed hole": ("02_flexpde_shell", {"mesh": "flexpde_shell_meshed_hole.msh"}),
    "ring": ("04_flexpde_ring", {}),
    "ring, constant viscosity": ("04_flexpde_ring", CONSTANT),
    "ring, straight cells, binary file": (
        "04_flexpde_ring", {"mesh": "flexpde_ring_straight.msh", "hole_keys": False}
    ),
    "ring, hole on top": ("05_flexpde_ring_top", {}),
    "ring, hole on top, as printed": ("05_flexpde_ring_top", PRINTED),
    "liner on the cylinder": ("07_grooved_liner", {}),
    "liner, constant viscosity": ("07_grooved_liner", CONSTANT),
    "liner, as printed": ("07_grooved_liner", PRINTED),
    "liner, holes by their closed curves": ("07_grooved_liner", {"hole_keys": False}),
    "liner, straight cells": (
        "07_grooved_liner", {"mesh": "grooved_liner_straight.msh", "hole_keys": False}
    ),
    "study size": ("08_flexpde_study_size", {}),
    "study size, as printed": ("08_flexpde_study_size", PRINTED),
}  # fmt: skip


@pytest.fixture(scope="module", params=CASES.values(), ids=CASES.keys())
def case(request, tmp_path_factory):
    """(scene, result, film grid of the Rust solver, its quadrature rule)."""
    name, changes = request.param
    folder = tmp_path_factory.mktemp("case")
    path = write_variant(SCENES / f"{name}.toml", folder / "scene.toml", **changes)
    result, grid = solve(path, unrolled=True, bars=False)
    rule, _ = crosscheck_data(path, folder / "data")
    return read_scene(path), result, grid, rule


@pytest.fixture(scope="module")
def same_rule(case):
    """The film solved by scikit-fem with the Rust solver's rule."""
    return solve_film(case[0], case[3])


def on_cylinder(points, radius):
    """Points of space of developed points: a place that does not depend on where a ring is cut."""
    phi = points[:, 0] / radius
    return np.column_stack([radius * np.cos(phi), radius * np.sin(phi), points[:, 1]])


def test_pressures_at_the_nodes_agree(case, same_rule):
    scene, _, grid, _ = case
    ours = on_cylinder(np.asarray(grid.points), scene.radius)
    theirs = on_cylinder(same_rule.mesh.points, scene.radius)
    distance, node = cKDTree(theirs).query(ours)
    assert distance.max() < 1e-9 * scene.radius
    assert len(np.unique(same_rule.mesh.unknown[node])) == same_rule.mesh.unknown.max() + 1
    difference = np.abs(grid.point_data["pressure"] - same_rule.pressure[node])
    assert difference.max() < 1e-9 * np.abs(same_rule.pressure).max()


def test_load_and_its_direction_agree(case, same_rule):
    _, result, _, _ = case
    assert quantity(result, "load") == pytest.approx(same_rule.load, rel=1e-9)
    assert quantity(result, "load_x") == pytest.approx(same_rule.load_x, abs=1e-9 * same_rule.load)
    assert quantity(result, "load_y") == pytest.approx(same_rule.load_y, abs=1e-9 * same_rule.load)
    for name, angle in (
        ("load_angle", same_rule.load_angle),
        ("attitude_angle", same_rule.attitude_angle),
    ):
        turn = np.exp(1j * (np.radians(quantity(result, name)) - angle))
        assert abs(np.angle(turn)) < 1e-9


def test_load_coefficient_agrees_or_is_absent(case, same_rule):
    _, result, _, _ = case
    if same_rule.load_coefficient is None:
        assert "load_coefficient" not in result["quantities"]
    else:
        found = quantity(result, "load_coefficient")
        assert found == pytest.approx(same_rule.load_coefficient, rel=1e-9)


def test_cost_of_the_quadrature_rule(case, same_rule):
    """Our rule against one of degree 12. h^3 and the load's cosine are no polynomials, so the rule
    leaves an error that falls with the cell size to the power degree + 1; it has to stay far below
    the 1e-4 that the P2 triangles themselves leave on these meshes."""
    exact = solve_film(case[0], rule_of_degree(12))
    cost = same_rule.load / exact.load - 1
    turn = same_rule.load_angle - exact.load_angle
    print(f"quadrature: {cost:+.2e} of the load, {turn:+.2e} rad of its direction")
    assert abs(cost) < 1e-6
    assert abs(turn) < 1e-6
