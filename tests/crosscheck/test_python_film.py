"""The film of the Python package: its arrays are in memory once, its samples are the quadratics of the film."""

import tracemalloc

import numpy as np
import oilwedge as ow
import pytest
import pyvista

import vtu_geometry
from oilwedge_run import SCENES
from python_package import ENGINE, SHELL


def test_fields_are_in_memory_once_and_cannot_be_written_to():
    scene = ow.Scene.read(ENGINE)
    tracemalloc.start()
    result = ow.solve(scene, bars=False)
    film = result.film
    arrays = [film.points, film.cells, *(film[name] for name in film.fields)]
    held, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    size = sum(array.nbytes for array in arrays)
    assert size > 500_000 and peak < 0.2 * size, (size, held, peak)
    for array in arrays:
        base = array
        while isinstance(base, np.ndarray):
            # The memory belongs to the vector that the program has filled.
            assert not base.flags.owndata and not base.flags.writeable
            base = base.base
        assert type(base).__name__ == "PySliceContainer"
        with pytest.raises(ValueError):
            array[0] = 0
    assert film.pressure is film.pressure
    assert np.shares_memory(film["pressure"], film.pressure)


def shapes(shares):
    a, b, c = shares
    return np.array([a * (2 * a - 1), b * (2 * b - 1), c * (2 * c - 1), 4 * a * b, 4 * b * c, 4 * c * a])


@pytest.mark.parametrize("unrolled", (False, True))
def test_samples_are_the_quadratics_of_the_film(unrolled):
    film = ow.solve(SHELL, unrolled=unrolled).film
    assert film.sample("pressure", [[100.0], [130.0], [180.0]], [0.01, 0.02]).shape == (3, 2)
    random = np.random.default_rng(1)
    chosen = random.integers(0, len(film.cells), 300)
    shares = random.dirichlet([1.0, 1.0, 1.0], 300) * 0.98 + 0.02 / 3
    weights = np.array([shapes(share) for share in shares])
    cells = film.cells[chosen]
    angle = np.einsum("ki,ki->k", weights, film.angle[cells])
    z = np.einsum("ki,ki->k", weights, film.z[cells])
    for name in ("pressure", "film_thickness", "viscosity"):
        wanted = np.einsum("ki,ki->k", weights, film[name][cells])
        assert film.sample(name, angle, z) == pytest.approx(wanted, rel=1e-9, abs=1e-9 * np.ptp(film[name]))
    assert np.isnan(film.sample("pressure", 10.0, 0.0)), "there is no film outside of the arc"
    for wrong in ("pressur", "volume_flow"):
        with pytest.raises((KeyError, ValueError), match="no field"):
            film.sample(wrong, 90, 0)


def test_no_sample_in_a_cavity_is_below_its_pressure():
    film = ow.solve(SCENES / "12_flexpde_shell_cavitated.toml", bars=False).film
    angle, z = np.linspace(40, 220, 361), np.linspace(film.z.min(), film.z.max(), 41)
    values = film.sample("pressure", angle[:, None], z)
    assert np.nanmin(values) == 0 < np.nanmax(values)


def test_pyvista_and_meshio_have_the_film(shell, tmp_path):
    film = shell.film
    grid = film.to_pyvista()
    assert np.array_equal(grid.points, film.points) and np.array_equal(vtu_geometry.cells(grid), film.cells)
    assert np.array_equal(grid["pressure"], film.pressure)
    mesh = film.to_meshio()
    mesh.write(tmp_path / "film.vtu")
    assert np.array_equal(pyvista.read(tmp_path / "film.vtu")["film_thickness"], film.film_thickness)
