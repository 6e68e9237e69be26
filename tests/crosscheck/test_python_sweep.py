"""Sweeps of the Python package: the table of the program, as a frame, a data set and a file."""

import csv
import io
import sys

import numpy as np
import oilwedge as ow
import pytest

from oilwedge_run import SCENES
from python_package import RING, STUDY, run

AXES = {"journal.speed": ["100 rpm", "300 rpm", "1000 rpm"], "eccentricity": {"from": 0.1, "to": 0.9, "steps": 9}}
SWEEP = '\n[sweep]\n"journal.speed" = ["100 rpm", "300 rpm", "1000 rpm"]\neccentricity = { from = 0.1, to = 0.9, steps = 9 }\n'


def lines_without_seconds(text):
    rows = list(csv.reader(io.StringIO(text)))
    assert rows[0][-1] == "seconds"
    return [row[:-1] for row in rows]


@pytest.fixture(scope="module")
def table():
    return ow.sweep(ow.Scene.read(STUDY) | {"oil.barus.alpha": "6e-8 1/Pa"}, AXES)


def test_a_sweep_is_that_of_the_program(table, tmp_path):
    scene = ow.Scene.read(STUDY) | {"oil.barus.alpha": "6e-8 1/Pa"}
    path = tmp_path / "map.toml"
    path.write_text(scene.text.replace("../meshes", str(SCENES.parent / "meshes")) + SWEEP)
    printed, _ = run("sweep", path, "--out", tmp_path / "map")
    text = (tmp_path / "map/sweep.csv").read_text()
    assert lines_without_seconds(table.to_csv()) == lines_without_seconds(text)
    # Without a folder there is no file to name.
    printed = printed.replace("; all are in sweep.csv", "")
    words = [line for line in printed.splitlines() if not line.startswith(("time ", "written "))]
    assert [line for line in str(table).splitlines() if not line.startswith("time ")] == words
    own = ow.sweep(path, out=tmp_path / "own", threads=1)
    assert lines_without_seconds(own.to_csv()) == lines_without_seconds(text)
    assert (tmp_path / "own/sweep.csv").read_text() == own.to_csv()
    assert ow.sweep(path, out=tmp_path / "own").to_csv() == own.to_csv(), "rows are kept"
    with pytest.raises(ValueError, match="fresh=True"):
        ow.sweep(path, out=tmp_path / "own", bars=False)
    with pytest.raises(ValueError, match="give axes"):
        ow.sweep(scene)
    with pytest.raises(ow.SceneError, match="sped"):
        ow.sweep(scene, {"sped": [1, 2]})


def test_a_sweep_has_chosen_columns():
    table = ow.sweep(RING, {"eccentricity": np.linspace(0.2, 0.8, 4)}, columns=["W kN", "h_min um"], bars=False)
    assert table.columns[:5] == ("case", "eccentricity", "status", "W [kN]", "h_min [um]")
    assert np.all(np.diff(table["W [kN]"]) > 0) and len(table) == 4
    data = table.to_xarray()
    assert data["W"].attrs == {"units": "kN", "long_name": ow.solve(RING)["load"].description}
    twice = ow.sweep(RING, {"eccentricity": [0.2, 0.4]}, columns=["W kN", "W N"], bars=False)
    with pytest.raises(ValueError, match='"W" in two columns'):
        twice.to_xarray()


def test_a_table_becomes_a_frame_a_data_set_and_a_file(table, tmp_path):
    pandas, xarray = pytest.importorskip("pandas"), pytest.importorskip("xarray")
    frame = table.to_pandas()
    assert tuple(frame.columns) == table.columns and len(frame) == len(table) == 27
    assert (frame["status"] == "no_solution").sum() == np.isnan(frame["load [N]"]).sum() > 0
    assert all(frame.loc[frame["status"] == "no_solution", "reason"].str.len() > 10)
    rows = list(csv.DictReader(io.StringIO(table.to_csv())))
    assert [float(row["load [N]"] or "nan") for row in rows] == pytest.approx(frame["load [N]"], nan_ok=True, abs=0)
    data = table.to_xarray()
    assert isinstance(data, xarray.Dataset)
    assert dict(data.sizes) == {"journal.speed": 3, "eccentricity": 9}
    assert data["load"].attrs == {"units": "N", "long_name": ow.solve(RING)["load"].description}
    place = {"journal.speed": 300, "eccentricity": 0.3}
    row = frame[(frame["journal.speed [rpm]"] == 300) & (frame["eccentricity"] == 0.3)]
    assert float(data["load"].sel(place)) == float(row["load [N]"].iloc[0])
    assert float(data["load_error"].sel(place)) == float(row["load error [N]"].iloc[0])
    table.to_parquet(tmp_path / "map.parquet")
    assert pandas.read_parquet(tmp_path / "map.parquet").equals(frame)


def test_missing_packages_are_named(table, monkeypatch):
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(ModuleNotFoundError, match="table.to_pandas\\(\\) needs pandas; install it: pip install pandas"):
        table.to_pandas()
