"""The film.vtu as a user of meshio meets it: by default it is not compressed, and zlib is known."""

import subprocess

import meshio
import numpy as np
import pytest
import pyvista

from oilwedge_run import SCENES, program


@pytest.mark.parametrize("options", [[], ["--vtu", "zlib"]])
def test_meshio_and_pyvista_read_the_same(tmp_path, options):
    scene = SCENES / "17_engine_main_bearing.toml"
    subprocess.run([program("OILWEDGE_BIN", "oilwedge"), "solve", scene, "--out", tmp_path, "--bars", "none", *options],
                   check=True, capture_output=True)
    film = meshio.read(tmp_path / "film.vtu")
    grid = pyvista.read(tmp_path / "film.vtu")
    (cells,) = film.cells
    assert cells.type == "triangle6" and len(cells.data) == grid.n_cells
    assert np.array_equal(film.points, grid.points)
    assert set(film.point_data) == set(grid.point_data)
    for name, values in film.point_data.items():
        assert np.array_equal(values, grid.point_data[name]), name
    assert set(film.field_data) == {"rupture", "reformation", "rim.groove"}
