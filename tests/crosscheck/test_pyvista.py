"""The film.vtu as a user of pyvista meets it: cell type, node order, geometry, interpolation."""

import subprocess

import numpy as np
import pytest
import pyvista

import vtu_geometry
from oilwedge_run import SCENES, crosscheck_data, program, written
from python_package import CYCLE, RING
from scene_file import read_scene, si, write_variant

CASES = {
    "shell": ("02_flexpde_shell", {}),
    "shell, straight cells": (
        "02_flexpde_shell", {"mesh": "flexpde_shell_straight.msh", "hole_keys": False}
    ),
    "shell, meshed hole": ("08_flexpde_study_size", {}),
    "plain ring": ("01_plain_ring", {}),
    "ring": ("04_flexpde_ring", {}),
    "liner on the cylinder": ("07_grooved_liner", {}),
}  # fmt: skip
OPENINGS = {  # area [m2] that is cut out of the mesh
    "shell": np.pi * 0.0085**2,
    "shell, straight cells": np.pi * 0.0085**2,
    "ring": np.pi * 0.0085**2,
    "liner on the cylinder": np.pi * (0.005**2 + 0.004**2)
    + 0.0375 * np.radians(20) * 0.75 * 0.075,
}
FIELDS = ("pressure", "film_thickness", "viscosity")


@pytest.fixture(scope="module", params=CASES.items(), ids=CASES.keys())
def film(request, tmp_path_factory):
    """Grids of one scene in the plane and on the cylinder, and the probes of the Rust side."""
    label, (name, changes) = request.param
    folder = tmp_path_factory.mktemp("film")
    path = write_variant(SCENES / f"{name}.toml", folder / "scene.toml", **changes)
    _, plane = written(path, folder / "plane", unrolled=True)
    _, cylinder = written(path, folder / "cylinder", unrolled=False)
    _, probes = crosscheck_data(path, folder / "data")
    nodes = np.asarray(plane.points)[vtu_geometry.cells(plane)][:, :, :2]
    return {
        "label": label, "scene": read_scene(path), "plane": plane, "cylinder": cylinder,
        "probes": probes, "places": vtu_geometry.locate(nodes, probes.points), "nodes": nodes,
    }  # fmt: skip


def straight_cells(nodes, tolerance=1e-9):
    """Cells with straight edges; gmsh itself puts middles on a seam only to 2e-11 of the edge."""
    return vtu_geometry.bulge(nodes).max(axis=1) < tolerance


def test_all_cells_are_quadratic_triangles_with_all_fields(film):
    for grid in (film["plane"], film["cylinder"]):
        assert set(grid.celltypes) == {pyvista.CellType.QUADRATIC_TRIANGLE}
        for name in FIELDS:
            values = grid.point_data[name]
            assert values.dtype == np.float64
            assert np.isfinite(values).all()
    assert np.ptp(film["plane"].points[:, 2]) == 0.0


def test_mid_side_nodes_are_in_their_slots(film):
    """Edge midpoints on straight edges; only the cells at a round rim have one curved edge."""
    bulge = vtu_geometry.bulge(film["nodes"])
    assert bulge.max() < 0.1
    assert (bulge > 1e-9).sum(axis=1).max() <= 1
    if film["label"] in ("plain ring", "shell, straight cells"):
        assert straight_cells(film["nodes"]).all()
    else:
        assert not straight_cells(film["nodes"]).all()


def test_area_is_that_of_the_liner_without_its_openings(film):
    """The rim of a hole is made of parabolas (or chords): 1e-6 (2e-4) of the liner's area."""
    scene, nodes = film["scene"], film["nodes"]
    assert vtu_geometry.corner_areas(nodes).min() > 0
    arc = np.ptp(nodes[:, :, 0])
    expected = arc * scene.length - OPENINGS.get(film["label"], 0.0)
    tolerance = 2e-4 if film["label"] == "shell, straight cells" else 1e-6
    assert vtu_geometry.area(nodes) == pytest.approx(expected, rel=tolerance)
    wrap = np.pi if "shell" in film["label"] else 2 * np.pi
    assert np.pi * 0.5 < arc / scene.radius
    assert arc == pytest.approx(wrap * scene.radius, rel=0.05)


def test_probes_inside_cells_give_our_interpolants(film):
    grid, probes = film["plane"], film["probes"]
    cells = vtu_geometry.cells(grid)
    for name, expected in (("pressure", probes.pressure), ("film_thickness", probes.film_thickness)):
        values = grid.point_data[name]
        found = []
        for cell, xi, eta in film["places"]:
            found.append(vtu_geometry.shape(xi, eta) @ values[cells[cell]])
        assert np.abs(np.array(found) - expected).max() < 1e-12 * np.abs(values).max()


def test_vtk_itself_interpolates_quadratically(film):
    """VTK's probe at the same points; it inverts the map of curved cells only roughly, so these
    are left to the test above."""
    grid, probes, nodes = film["plane"], film["probes"], film["nodes"]
    straight = straight_cells(nodes, tolerance=1e-13)
    usable = np.array([straight[cell] for cell, _, _ in film["places"]])
    assert usable.any()
    points = np.column_stack([probes.points[usable], np.zeros(usable.sum())])
    sampled = pyvista.PolyData(points).sample(grid)
    assert sampled["vtkValidPointMask"].all()
    difference = np.abs(sampled["pressure"] - probes.pressure[usable]).max()
    assert difference < 1e-12 * np.abs(grid.point_data["pressure"]).max()


def test_cylinder_has_the_radius_and_the_same_fields(film):
    scene, plane, cylinder = film["scene"], film["plane"], film["cylinder"]
    x, y, z = np.asarray(cylinder.points).T
    assert np.abs(np.hypot(x, y) / scene.radius - 1).max() < 1e-12
    assert z.min() == pytest.approx(-scene.length / 2) and z.max() == pytest.approx(scene.length / 2)
    h = scene.film_thickness(scene.radius * np.arctan2(y, x), z)
    assert np.abs(cylinder.point_data["film_thickness"] - h).max() < 1e-12 * h.max()
    for name in FIELDS:
        assert plane.point_data[name].min() == cylinder.point_data[name].min()
        assert plane.point_data[name].max() == cylinder.point_data[name].max()


@pytest.mark.parametrize(("model", "unrolled"), [("reynolds", True), ("jfo", False)])
def test_a_broken_film_has_a_film_fraction_and_no_tension(model, unrolled, tmp_path):
    """Scene 07 with a cavity: p >= p_cav everywhere, 0 < theta <= 1, and p = p_cav wherever theta < 1."""
    cavity = "-0.2 bar"
    scene = write_variant(
        SCENES / "07_grooved_liner.toml",
        tmp_path / "scene.toml",
        cavitation={"model": model, "pressure": cavity},
    )
    result, grid = written(scene, tmp_path / "out", unrolled=unrolled)
    pressure = grid.point_data["pressure"]
    assert pressure.min() == result["quantities"]["pressure_min"]["value"] == pytest.approx(si(cavity), rel=1e-12)
    assert pressure.max() == pytest.approx(result["quantities"]["pressure_max"]["value"], rel=2e-3)
    assert ("film_fraction" in grid.point_data) == (model == "jfo")
    if model == "jfo":
        fraction = grid.point_data["film_fraction"]
        assert fraction.min() > 0 and fraction.max() == 1
        assert fraction.min() == result["quantities"]["film_fraction_min"]["value"]
        assert pressure[fraction < 1] == pytest.approx(si(cavity), rel=1e-9)
        assert 0.05 < (fraction < 1).mean() < 0.95


def test_the_animation_of_a_cycle_has_the_crank_angle_as_its_time(tmp_path):
    """Each film is as thick as the place of the journal's axis says."""
    scene, out = tmp_path / "cycle.toml", tmp_path / "out"
    scene.write_text(CYCLE)
    command = [program("OILWEDGE_BIN", "oilwedge"), "solve", str(scene), "--out", str(out), "--frames", "8", "--bars", "none"]
    subprocess.run(command, check=True, capture_output=True)
    reader = pyvista.get_reader(out / "film.pvd")
    np.testing.assert_allclose(reader.time_values, np.arange(8) * 45.0)
    least = []
    for angle in reader.time_values:
        reader.set_active_time_value(angle)
        film = reader.read()[0]
        assert set(film.celltypes) == {pyvista.CellType.QUADRATIC_TRIANGLE}
        axis = np.asarray(film.field_data["journal_axis"]).reshape(2, 3)
        np.testing.assert_allclose(axis[:, 2], [-0.0125, 0.0125])
        directions = film.points[:, :2] / 0.025
        thickness = 30e-6 - directions @ axis[0, :2]
        np.testing.assert_allclose(film.point_data["film_thickness"], thickness, rtol=1e-6)
        least.append(thickness.min())
    assert max(least) > 1.2 * min(least)
    # Results of another film take them away.
    written(RING, out, unrolled=False)
    assert not (out / "film.pvd").exists() and not (out / "frames").exists()
