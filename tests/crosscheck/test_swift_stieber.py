"""Swift-Stieber films: `obstacle.py` against closed forms, `film.py` against recomputed bearings, the Rust
solver against `film.py` on the same mesh with the same quadrature rule.

References and their sources: tests/data/journal_bearings.json.
"""

import json
import subprocess
import tomllib

import numpy as np
import pytest
from scipy.sparse import diags_array

from film import reduced_pressure, rule_of_degree, solve_film
from obstacle import solve_bounded
from oilwedge_run import REPOSITORY, SCENES, crosscheck_data, program, quantity, solve
from scene_file import read_scene, write_variant

DATA = json.loads((REPOSITORY / "tests/data/journal_bearings.json").read_text())
BARUS = {"alpha": "2.5e-8 1/Pa"}


def bound(pressure):
    return {"model": "reynolds", "pressure": pressure}


def hanging_string(nodes, gravity, height):
    """-u'' = -gravity on (0, 1) above u = 0, both ends held at `height`."""
    step = 1 / (nodes - 1)
    matrix = diags_array([-np.ones(nodes - 1), 2 * np.ones(nodes), -np.ones(nodes - 1)], offsets=[-1, 0, 1]).tocsr()
    right = np.full(nodes, -gravity * step**2)
    return matrix, right, {0: height, nodes - 1: height}


def test_a_string_lies_on_the_floor_where_it_should():
    """Parabolas meet the floor smoothly at sqrt(2 height/gravity) from the ends: on a node, so differences are
    exact."""
    nodes, gravity, place = 401, 8.0, 0.25
    height = gravity * place**2 / 2
    matrix, right, fixed = hanging_string(nodes, gravity, height)
    u, force = solve_bounded(matrix, right, 0.0, np.arange(nodes), fixed)
    x = np.linspace(0, 1, nodes)
    distance = np.minimum(x, 1 - x)
    expected = gravity / 2 * np.maximum(place - distance, 0) ** 2
    assert np.abs(u - expected).max() < 1e-8 * height
    inside = distance > place + 1e-9
    assert np.allclose(force[inside], gravity / (nodes - 1) ** 2, rtol=1e-4)
    assert np.abs(force[distance < place - 1e-9]).max() < 1e-6 * force.max()


def drawn_ring(folder, slenderness, eccentricity, film_start, barus=None):
    """A ring of radius 50 mm, clearance 50 um, meshed by the program; 100 rad/s and 0.02 Pa s."""
    scene = folder / "drawn.toml"
    start = 'film_start = "0 deg"' if film_start else ""
    scene.write_text(f"""title = "ring"
[bearing]
diameter = "100 mm"
length = "{100 * slenderness} mm"
clearance = "50 um"
{start}
[mesh]
size = "5 mm"
[journal]
speed = "100 rad/s"
eccentricity = {eccentricity}
min_film_angle = "180 deg"
[oil]
viscosity = "0.02 Pa.s"
""")
    mesh = write_mesh(scene, folder)
    return write_variant(scene, folder / "ring.toml", mesh=mesh, cavitation=bound("0 Pa"), barus=barus)


def write_mesh(scene, folder):
    path = folder / "drawn.msh"
    command = [program("OILWEDGE_BIN", "oilwedge"), "mesh", str(scene), "-o", str(path)]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    return path


def check_ring(film, row):
    """What 2000 to 8000 nodes leave. The largest nodal value misses a part of the reduced pressure, so that is
    compared."""
    assert film.load * 1e-6 / (0.01 * row["B_over_D"] * 2) == pytest.approx(row["So"], rel=5e-4)
    assert np.degrees(film.attitude_angle) == pytest.approx(row["attitude_deg"], abs=0.02)
    found, expected = (reduced_pressure(p, row.get("G", 0)) for p in (film.pressure.max() / 2e6, row["P_max"]))
    assert found == pytest.approx(expected, rel=3e-3)


@pytest.mark.parametrize("number", [7, 15])
def test_ring_with_a_film_start(number, tmp_path):
    row = DATA["plain360_swift_stieber"]["rows"][number]
    scene = read_scene(drawn_ring(tmp_path, row["B_over_D"], row["eps"], True))
    check_ring(solve_film(scene, rule_of_degree(8)), row)


@pytest.mark.parametrize("number", [0, 1])
def test_periodic_ring(number, tmp_path):
    row = DATA["periodic_swift_stieber"]["rows"][number]
    scene = read_scene(drawn_ring(tmp_path, row["B_over_D"], row["eps"], False))
    check_ring(solve_film(scene, rule_of_degree(8)), row)


@pytest.mark.parametrize("number", [1, 4])
def test_ring_with_barus_oil(number, tmp_path):
    """G = alpha mu0 omega/psi^2 = alpha 2 MPa."""
    row = DATA["barus_exact_transform"]["rows"][number]
    barus = {"alpha": f"{row['G'] / 2e6} 1/Pa"}
    scene = read_scene(drawn_ring(tmp_path, row["B_over_D"], row["eps"], True, barus))
    check_ring(solve_film(scene, rule_of_degree(8)), row)


def test_squeeze_film_of_a_ring(tmp_path):
    """Butenschoen 1976, B/D 0.5, eps 0.5: So_V 3.675, printed to four digits and 0.1 % off by his grid."""
    path = drawn_ring(tmp_path, 0.5, 0.5, False)
    scene = read_scene(path)
    scene.speed, scene.squeeze = 0.0, (5e-3, 0.0)
    film = solve_film(scene, rule_of_degree(8))
    # |deps/dt| = 5 mm/s / 50 um = 100 1/s.
    assert film.load * 1e-6 / (0.1 * 0.05 * 0.02 * 100) == pytest.approx(3.675, rel=2e-3)
    assert np.degrees(film.load_angle) % 360 == pytest.approx(180, abs=1e-2)


CASES = {
    "plain ring": ("01_plain_ring", {"cavitation": bound("0 bar")}),
    "plain ring, Barus": ("01_plain_ring", {"cavitation": bound("0 bar"), "barus": BARUS}),
    "shell, constant viscosity, bound of the ends": (
        "02_flexpde_shell", {"cavitation": bound("0.98 bar"), "barus": None}
    ),
    "shell, straight cells": (
        "02_flexpde_shell",
        {"cavitation": bound("0 bar"), "mesh": "flexpde_shell_straight.msh", "hole_keys": False},
    ),
    "shell, meshed hole": (
        "02_flexpde_shell", {"cavitation": bound("0 bar"), "mesh": "flexpde_shell_meshed_hole.msh"}
    ),
    "ring, bound below the ends": ("04_flexpde_ring", {"cavitation": bound("-0.5 bar")}),
    "liner": ("07_grooved_liner", {"cavitation": bound("0 bar")}),
}  # fmt: skip


# Tables of what the film of the cross-check does not have.
OTHERS = {"orbit", "bore", "shaft", "contact", "roughness", "liner"}


def uses_the_model(path):
    """A steady film by the model, of smooth and round rigid surfaces: an orbit has many films."""
    table = tomllib.loads(path.read_text())
    printed = table["oil"].get("barus", {}).get("form") == "as-printed"
    return table.get("cavitation", {}).get("model") == "reynolds" and not printed and not OTHERS & table.keys()


SHIPPED = sorted(path.stem for path in SCENES.glob("*.toml") if uses_the_model(path))


def compare(path, folder):
    """Both films of a scene on a mesh file. The bounded film is unique, so they agree to what the methods leave
    (1e-10)."""
    result, grid = solve(path, unrolled=True, bars=False)
    rule, _ = crosscheck_data(path, folder / "data")
    film = solve_film(read_scene(path), rule)
    cost = quantity(result, "load") / film.load - 1
    print(f"load: {cost:+.2e}")
    assert quantity(result, "load") == pytest.approx(film.load, rel=1e-8)
    assert quantity(result, "load_x") == pytest.approx(film.load_x, abs=1e-8 * film.load)
    assert quantity(result, "load_y") == pytest.approx(film.load_y, abs=1e-8 * film.load)
    assert grid.point_data["pressure"].max() == pytest.approx(film.pressure.max(), rel=1e-6)
    # The greatest pressure lies between nodes, more so where the peak is narrow.
    assert 1 - 1e-9 <= quantity(result, "pressure_max") / film.pressure.max() <= 1.03


@pytest.mark.parametrize(("name", "changes"), CASES.values(), ids=CASES.keys())
def test_the_program_agrees(name, changes, tmp_path):
    compare(write_variant(SCENES / f"{name}.toml", tmp_path / "scene.toml", **changes), tmp_path)


@pytest.mark.parametrize("name", SHIPPED)
def test_shipped_scenes_agree(name, tmp_path):
    """A liner that the program meshes goes through a mesh file, and the position found for a load is given."""
    source = SCENES / f"{name}.toml"
    table = tomllib.loads(source.read_text())
    result, _ = solve(source, unrolled=True, bars=False)
    mesh = write_mesh(source, tmp_path) if "file" not in table.get("mesh", {}) else None
    position = None
    if "load" in table:
        angle = f"{quantity(result, 'min_film_angle')!r} deg"
        position = {"eccentricity": quantity(result, "eccentricity"), "min_film_angle": angle}
        if "tilt_x" in result["quantities"]:
            position["tilt"] = {axis: f"{quantity(result, f'tilt_{axis}')!r} rad" for axis in "xy"}
    path = write_variant(source, tmp_path / "scene.toml", mesh=mesh, position=position)
    compare(path, tmp_path)
