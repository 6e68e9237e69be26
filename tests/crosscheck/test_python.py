"""The Python package: its results, tables and pictures are those of the program."""

import pickle

import numpy as np
import oilwedge as ow
import pytest
import pyvista

import vtu_geometry
from oilwedge_run import SCENES
from python_package import CYCLE, ENGINE, RING, SHELL, run, solved, without_seconds, without_times


@pytest.mark.parametrize("path", sorted(SCENES.glob("0[1-7]*.toml")) + [ENGINE], ids=lambda path: path.stem)
def test_every_bit_is_that_of_the_program(path, tmp_path):
    wanted = solved(path, tmp_path, "--vtu", "none")
    result = ow.solve(path)
    assert without_times(result.to_dict()) == without_times(wanted)
    for name, quantity in result.items():
        it = wanted["quantities"][name]
        assert (quantity.value, quantity.error, quantity.unit, quantity.symbol) == (
            it["value"],
            it["error"],
            it["unit"],
            it["symbol"],
        )
    grid = pyvista.read(tmp_path / "film.vtu")
    film = result.film
    assert np.array_equal(film.points, grid.points)
    assert np.array_equal(film.cells, vtu_geometry.cells(grid))
    for data in (grid.point_data, grid.cell_data):
        for name in data.keys():
            assert np.array_equal(film[name], data[name]), name


def test_options_are_those_of_the_program(tmp_path):
    wanted = solved(ENGINE, tmp_path, "--bars", "none", "--unrolled", "--standard", "--theories", "--threads", "1")
    result = ow.solve(ENGINE, bars=False, unrolled=True, add_ons=["standard", "theories"], threads=1)
    assert without_times(result.to_dict()).keys() == without_times(wanted).keys()
    assert result["eccentricity"].value == wanted["quantities"]["eccentricity"]["value"]
    assert result["eccentricity"].error is None
    assert np.all(result.film.points[:, 2] == 0)
    with pytest.raises(ValueError, match="standards"):
        ow.solve(RING, add_ons=["standards"])


def test_the_table_is_that_of_the_program(tmp_path, shell):
    printed, _ = run("solve", SHELL, "--out", tmp_path)
    of_run = ("time ", "written ", "more ")
    lines = [line for line in printed.splitlines() if not line.startswith(of_run)]
    assert [line for line in str(shell).splitlines() if not line.startswith("time ")] == lines
    printed, _ = run("solve", SHELL, "--out", tmp_path, "--all")
    lines = [line for line in printed.splitlines() if not line.startswith(of_run)]
    assert [line for line in shell.table().splitlines() if not line.startswith("time ")] == lines


def test_spread_and_sensitivities_are_those_of_the_program(tmp_path):
    scene = ow.Scene.read(SCENES / "37_tolerances.toml") | {"mesh.size": "5 mm"}
    (tmp_path / "scene.toml").write_text(scene.text)
    wanted = solved(tmp_path / "scene.toml", tmp_path, "--bars", "none")["quantities"]["film_thickness_min"]
    result = ow.solve(scene, bars=False)
    least = result.spread.loc["film_thickness_min"]
    assert least["rss"] == wanted["spread"]["rss"] and least["worst_case"] == wanted["spread"]["worst_case"]
    assert least["oil.viscosity"] == wanted["spread"]["shares"]["oil.viscosity"]
    found = result.sensitivity("h_min")
    assert list(found.columns) == ["value", "unit", "log", "is_by_films", "has_kink"] and found.index.name == "key"
    for key, it in wanted["sensitivity"].items():
        assert found.loc[key, "value"] == it["value"] and found.loc[key, "unit"] == it["unit"]
    assert "eccentricity" in result.plot("tolerances").svg
    drawn = SCENES / "09_drawn_ring.toml"
    ring = ow.solve(drawn, bars=False, sensitivity=True)
    assert ring.sensitivity("load").loc["oil.viscosity", "log"] == pytest.approx(1, abs=1e-8)
    with pytest.raises(ow.OilwedgeError, match="no key of the scene has a tolerance"):
        _ = ring.spread
    with pytest.raises(ow.OilwedgeError, match="sensitivity=True"):
        ow.solve(drawn, bars=False).sensitivity("load")
    with pytest.raises(ValueError, match="with tolerances only"):
        ow.solve(SCENES / "27_big_end_orbit.toml", sensitivity=True)


def test_a_quantity_knows_what_it_is(shell):
    load = shell["load"]
    assert load.symbol == "W" and load.unit == "N"
    assert load.to("kN").value == pytest.approx(1e-3 * load.value, rel=1e-15)
    assert load.to("kN").error == pytest.approx(1e-3 * load.error, rel=1e-15)
    assert load.description in ow.explain("load") and load.definition in ow.explain("load")
    assert load.__doc__ == load.definition
    assert "±" in str(load) and str(load).endswith(" N")
    assert f"{load:.1f}" == f"{load.value:.1f}"
    flow = next(quantity for name, quantity in shell.items() if name.startswith("feed_flow."))
    assert flow.description and flow.to("ml/s").value == pytest.approx(1e6 * flow.value)
    for wrong, words in (("mm", "force"), ("kNN", "did you mean")):
        with pytest.raises(ValueError, match=words):
            load.to(wrong)
    assert shell["h_min"] is shell["film_thickness_min"], "quantities are found by their symbols too"
    for wrong, words in (("lod", 'no quantity.*did you mean load'), ("pressure", 'pressure_max.*result.film."pressure"'), ("zzz", "it has load")):
        with pytest.raises(KeyError, match=words):
            shell[wrong]
    assert "<td>h_min</td>" in shell._repr_html_() and shell.title in shell._repr_html_()
    assert "&quot;" in shell.scene._repr_html_()
    with pytest.raises(ValueError, match="did you mean"):
        ow.explain("pressure_mx")


def test_pictures_and_reports_are_those_of_the_program(shell, tmp_path):
    solved(SHELL, tmp_path, "--plot", "--report")
    picture = shell.plot("pressure", tmp_path / "p.svg")
    assert (tmp_path / "p.svg").read_text() == (tmp_path / "plot/pressure.svg").read_text() == picture._repr_svg_()
    picture.save(tmp_path / "p.png")
    assert (tmp_path / "p.png").read_bytes() == (tmp_path / "plot/pressure.png").read_bytes()
    page = shell.report(tmp_path / "page.html")
    wanted, found = ((tmp_path / name).read_text() for name in ("report.html", "page.html"))
    assert without_seconds(found, shell) == without_seconds(wanted, shell)
    assert page._repr_html_().startswith("<iframe") and "&lt;!doctype html" in page._repr_html_().lower()
    for width in (-5, 0, 1e9, float("nan")):
        with pytest.raises(ValueError, match="from 60 to 400 is wanted"):
            shell.plot("pressure", width=width)
    with pytest.raises(ValueError, match="there are pressure"):
        shell.plot("presure")
    with pytest.raises(ValueError, match=".svg or .png"):
        picture.save(tmp_path / "p.pdf")


def test_results_travel_to_other_processes(shell):
    again = pickle.loads(pickle.dumps(shell))
    assert again.to_dict() == shell.to_dict() and str(again) == str(shell) and again.table() == shell.table()
    assert np.array_equal(again.film.pressure, shell.film.pressure) and not again.film.pressure.flags.writeable
    assert again.plot("pressure").svg == shell.plot("pressure").svg


def test_an_orbit_has_its_path():
    result = ow.solve(ow.Scene.parse(CYCLE), bars=False)
    assert result.orbit is not None
    assert {"crank angle [deg]", "e_x/c [1]"} <= result.orbit.keys()
    assert np.all(np.diff(result.orbit["crank angle [deg]"]) > 0)
