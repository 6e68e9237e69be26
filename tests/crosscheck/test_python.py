"""The Python package: its numbers and words are those of the program, and its fields are in memory once."""

import csv
import io
import json
import os
import pickle
import signal
import subprocess
import sys
import threading
import time
import tracemalloc
from pathlib import Path

import numpy as np
import oilwedge as ow
import pytest
import pyvista

import vtu_geometry
from oilwedge_run import REPOSITORY, SCENES, program

RING = SCENES / "01_plain_ring.toml"
SHELL = SCENES / "02_flexpde_shell.toml"
ENGINE = SCENES / "17_engine_main_bearing.toml"
WRONG = json.loads((REPOSITORY / "tests/data/wrong_scenes.json").read_text())
# Pressure-dependent viscosity above its limit.
NO_FILM = {"oil.barus.alpha": "1e-5 1/Pa", "journal.eccentricity": 0.9}


def run(*arguments, status=0):
    """What the program prints, and its complaints."""
    ended = subprocess.run([program("OILWEDGE_BIN", "oilwedge"), *map(str, arguments)], capture_output=True, text=True)
    assert ended.returncode == status, ended.stderr
    return ended.stdout, ended.stderr


def solved(scene, out, *more):
    """The object of result.json."""
    run("solve", scene, "--out", out, *more)
    return json.loads((out / "result.json").read_text())


def without_times(result):
    return {key: value for key, value in result.items() if key not in ("timing_s", "levels")}


@pytest.fixture(scope="module")
def shell():
    return ow.solve(ow.Scene.read(SHELL))


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
    with pytest.raises(KeyError, match="no quantity"):
        shell["lod"]
    with pytest.raises(ValueError, match="did you mean"):
        ow.explain("pressure_mx")


def complaints_in(words, complaints):
    for complaint in complaints:
        shown = f"{complaint.key}: {complaint.message}" if complaint.key else complaint.message
        assert shown in words, f"{shown}\n{words}"
        assert complaint.help in words, f"{complaint.help}\n{words}"


@pytest.mark.parametrize("number", range(len(WRONG["edits"])))
def test_complaints_are_those_of_the_terminal(number, tmp_path):
    old, new = WRONG["edits"][number]
    path = tmp_path / "wrong.toml"
    path.write_text(WRONG["scene"].replace(old, new, 1))
    _, words = run("sweep", path, "--out", tmp_path / "out", status=2)
    with pytest.raises(ow.SceneError) as caught:
        ow.sweep(path)
    assert isinstance(caught.value, ValueError) and caught.value.complaints
    complaints_in(words, caught.value.complaints)
    assert words.count("help: ") == len(caught.value.complaints)
    for complaint in caught.value.complaints:
        assert f"{complaint.message} ({complaint.help})" in str(caught.value)
        if complaint.span and not complaint.key.startswith("sweep."):
            assert complaint.value in path.read_text()
    again = pickle.loads(pickle.dumps(caught.value))
    assert again.complaints == caught.value.complaints and str(again) == str(caught.value)


BAD_FILES = {
    "syntax": b'[bearing\ndiameter = "75 mm"\n',
    "bytes": b"title = \xff\xfe\n",
    "mesh": b"$MeshFormat\n4.1 0 8\n$EndMeshFormat\n",
    "large": b"#" * (1 << 21),
}


@pytest.mark.parametrize("kind", BAD_FILES)
def test_files_that_are_no_scenes_have_the_words_of_the_terminal(kind, tmp_path):
    path = tmp_path / "wrong.toml"
    path.write_bytes(BAD_FILES[kind])
    for wrong in (path, tmp_path, tmp_path / "none.toml"):
        _, words = run("solve", wrong, "--out", tmp_path / "out", status=2)
        with pytest.raises(ow.SceneError) as caught:
            ow.Scene.read(wrong)
        if caught.value.complaints:
            complaints_in(words, caught.value.complaints)
        else:
            assert str(caught.value) in words


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ('"feed_hole"', '"feed_hall"'),
        ('"10 rad/s"', '"10 rad/s"'),
    ],
)
def test_meshes_that_do_not_fit_have_the_words_of_the_terminal(old, new, tmp_path):
    text = SHELL.read_text().replace(old, new)
    mesh = tmp_path / "mesh.msh"
    original = (SCENES / "../meshes/flexpde_shell.msh").resolve()
    mesh.write_bytes(original.read_bytes() if old != new else original.read_bytes()[:5000])
    path = tmp_path / "scene.toml"
    path.write_text(text.replace("../meshes/flexpde_shell.msh", "mesh.msh"))
    _, words = run("solve", path, "--out", tmp_path / "out", status=2)
    with pytest.raises(ow.MeshError) as caught:
        ow.solve(path)
    assert str(caught.value) in words


def test_results_that_are_no_answers_are_exceptions(tmp_path):
    with pytest.raises(ow.NoSolution) as caught:
        ow.solve(ow.Scene.read(SHELL) | NO_FILM)
    result = caught.value.result
    assert result.status == "no_solution" and not result and result.reason == str(caught.value)
    with pytest.raises(ow.OilwedgeError, match="no film"):
        result.film
    with pytest.raises(ow.NotConverged) as reached:
        ow.solve(ow.Scene.read(ENGINE) | {"mesh.tolerance": "0.0001 %"}, max_seconds=0.2)
    assert reached.value.result["load"].error is not None
    again = pickle.loads(pickle.dumps(reached.value))
    assert again.result.to_dict() == reached.value.result.to_dict()


@pytest.mark.parametrize("wrong", ({"max_seconds": 0}, {"max_seconds": float("nan")}, {"max_unknowns": 0}, {"threads": 0}))
def test_arguments_that_make_no_sense_are_refused(wrong):
    with pytest.raises(ValueError, match="wanted"):
        ow.solve(RING, **wrong)


def test_a_tolerance_needs_bars(tmp_path):
    with pytest.raises(ValueError, match="conflicts with the mesh.tolerance"):
        ow.solve(ow.Scene.read(ENGINE) | {"mesh.tolerance": "5 %"}, bars=False)


def test_a_fault_of_the_program_is_an_exception(shell):
    """Triangles that refer to nodes which do not exist: no user makes them."""
    film = pickle.loads(pickle.dumps(shell.film))
    film._parts["cells"] = np.full((4, 6), 10**9, dtype=np.uint32)
    with pytest.raises(ow.InternalError, match="report the scene"):
        film.sample("pressure", 90, 0)
    assert ow.solve(RING)["load"].value > 0


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


def test_pyvista_and_meshio_have_the_film(shell, tmp_path):
    film = shell.film
    grid = film.to_pyvista()
    assert np.array_equal(grid.points, film.points) and np.array_equal(vtu_geometry.cells(grid), film.cells)
    assert np.array_equal(grid["pressure"], film.pressure)
    mesh = film.to_meshio()
    mesh.write(tmp_path / "film.vtu")
    assert np.array_equal(pyvista.read(tmp_path / "film.vtu")["film_thickness"], film.film_thickness)


def test_pictures_and_reports_are_those_of_the_program(shell, tmp_path):
    solved(SHELL, tmp_path, "--plot", "--report")
    picture = shell.plot("pressure", tmp_path / "p.svg")
    assert (tmp_path / "p.svg").read_text() == (tmp_path / "plot/pressure.svg").read_text() == picture._repr_svg_()
    picture.save(tmp_path / "p.png")
    assert (tmp_path / "p.png").read_bytes() == (tmp_path / "plot/pressure.png").read_bytes()
    page = shell.report(tmp_path / "page.html")
    wanted, found = ((tmp_path / name).read_text() for name in ("report.html", "page.html"))
    assert abs(len(found) - len(wanted)) < 200 and found[:2000] == wanted[:2000]
    assert page._repr_html_().startswith("<iframe") and "&lt;!doctype html" in page._repr_html_().lower()
    with pytest.raises(ValueError, match="there are pressure"):
        shell.plot("presure")
    with pytest.raises(ValueError, match=".svg or .png"):
        picture.save(tmp_path / "p.pdf")


def test_a_scene_is_made_of_a_file_a_mapping_or_another_scene(tmp_path):
    scene = ow.Scene.read(RING)
    assert scene.text == RING.read_text() and scene.title in repr(scene)
    faster = scene | {"journal.speed": "3000 rpm", "eccentricity": np.float64(0.5)}
    assert faster is not scene and 'speed = "3000 rpm"' in faster.text and "eccentricity = 0.5" in faster.text
    assert (scene | {}) == scene and pickle.loads(pickle.dumps(faster)) == faster
    path = tmp_path / "scene.toml"
    path.write_text(faster.text.replace("../meshes", str(SCENES.parent / "meshes")))
    assert ow.solve(faster)["load"].value == ow.solve(path)["load"].value
    described = {
        "title": "of a mapping",
        "bearing": {"diameter": "75 mm", "length": "75 mm", "clearance": "37.5 um"},
        "mesh": {"size": "3 mm"},
        "feed": [{"group": "hole", "hole": {"diameter": "5 mm", "angle": "90 deg"}, "pressure": "1 bar"}],
        "journal": {"speed": "10 rad/s", "eccentricity": np.float64(0.6), "min_film_angle": "180 deg"},
        "oil": {"viscosity": "0.4 Pa.s"},
    }
    mapped = ow.Scene(described)
    assert mapped.title == "of a mapping"
    assert ow.solve(mapped)["load"] == ow.solve(described)["load"] == ow.solve(ow.Scene.parse(mapped.text))["load"]
    other = mapped | {"feed.hole.pressure": "2 bar"}
    assert ow.solve(other)["load"] != ow.solve(mapped)["load"]
    for kind in ("plain", "hole", "groove", "engine-main", "heat", "pad"):
        run("new", tmp_path / f"{kind}.toml", "--kind", kind)
        assert (tmp_path / f"{kind}.toml").read_text().endswith(ow.Scene.new(kind).text)
    with pytest.raises(ValueError, match="there are plain"):
        ow.Scene.new("plane")


@pytest.mark.parametrize(
    ("changes", "key", "words"),
    [
        ({"jurnal.speed": "3000 rpm"}, "jurnal.speed", "no table of a scene"),
        ({"sped": "3000 rpm"}, "sped", "not known"),
        ({"journal.speed": 3000}, "journal.speed", "bare number"),
        ({"journal.speed": "3000 mm"}, "journal.speed", "unit of length"),
        ({"journal.sped": "3000 rpm"}, "journal.sped", "not known"),
        ({"eccentricity": 1.2}, "journal.eccentricity", ""),
        ({"eccentricity": float("nan")}, "", ""),
    ],
)
def test_changes_that_make_no_scene_are_refused(changes, key, words):
    with pytest.raises(ow.SceneError) as caught:
        ow.Scene.read(RING) | changes
    assert any(complaint.key.startswith(key) and words in complaint.message for complaint in caught.value.complaints)


@pytest.mark.parametrize("wrong", ({"title": None}, {"journal": {"speed": {1, 2}}}, {1: 2}))
def test_what_toml_cannot_hold_is_refused(wrong):
    with pytest.raises(TypeError):
        ow.Scene(wrong)


def test_results_travel_to_other_processes(shell):
    again = pickle.loads(pickle.dumps(shell))
    assert again.to_dict() == shell.to_dict() and str(again) == str(shell) and again.table() == shell.table()
    assert np.array_equal(again.film.pressure, shell.film.pressure) and not again.film.pressure.flags.writeable
    assert again.plot("pressure").svg == shell.plot("pressure").svg


def test_an_orbit_has_its_path():
    result = ow.solve(SCENES / "27_big_end_orbit.toml", bars=False)
    assert result.orbit is not None
    assert {"crank angle [deg]", "e_x/c [1]"} <= result.orbit.keys()
    assert np.all(np.diff(result.orbit["crank angle [deg]"]) > 0)


AXES = {"journal.speed": ["100 rpm", "300 rpm", "1000 rpm"], "eccentricity": {"from": 0.1, "to": 0.9, "steps": 9}}
SWEEP = '\n[sweep]\n"journal.speed" = ["100 rpm", "300 rpm", "1000 rpm"]\neccentricity = { from = 0.1, to = 0.9, steps = 9 }\n'


def lines_without_seconds(text):
    rows = list(csv.reader(io.StringIO(text)))
    assert rows[0][-1] == "seconds"
    return [row[:-1] for row in rows]


@pytest.fixture(scope="module")
def table():
    return ow.sweep(ow.Scene.read(SHELL) | {"oil.barus.alpha": "6e-8 1/Pa"}, AXES)


def test_a_sweep_is_that_of_the_program(table, tmp_path):
    scene = ow.Scene.read(SHELL) | {"oil.barus.alpha": "6e-8 1/Pa"}
    path = tmp_path / "map.toml"
    path.write_text(scene.text.replace("../meshes", str(SCENES.parent / "meshes")) + SWEEP)
    printed, _ = run("sweep", path, "--out", tmp_path / "map")
    text = (tmp_path / "map/sweep.csv").read_text()
    assert lines_without_seconds(table.to_csv()) == lines_without_seconds(text)
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


def long_scene():
    """One that takes a minute and more."""
    return ow.Scene.read(ENGINE) | {"mesh.tolerance": "0.00001 %"}


def test_other_threads_run_meanwhile():
    """A thread counts while another one solves; two threads solve two scenes."""
    scene = ow.Scene.read(ENGINE)
    alone = ow.solve(scene, threads=1)
    counted, results = [0], {}

    def solve(name):
        results[name] = ow.solve(scene, threads=1)

    threads = [threading.Thread(target=solve, args=(name,)) for name in "ab"]
    for thread in threads:
        thread.start()
    while any(thread.is_alive() for thread in threads):
        counted[0] += 1
        time.sleep(0.001)
    assert counted[0] > 50
    for result in results.values():
        assert without_times(result.to_dict()) == without_times(alone.to_dict())


INTERRUPTED = """
import sys, time
import oilwedge as ow
scene = ow.Scene.read(sys.argv[1])
print("begin", flush=True)
try:
    {call}
except KeyboardInterrupt:
    print("interrupted", time.time(), flush=True)
print(ow.solve(sys.argv[2])["load"].value)
"""


@pytest.mark.parametrize(
    "call",
    (
        'ow.solve(scene | {"mesh.tolerance": "0.00001 %"}, max_unknowns=10**8)',
        'ow.sweep(scene | {"mesh.tolerance": "0.01 %"}, {"journal.speed": [f"{n} rpm" for n in range(1000, 9000)]})',
    ),
)
def test_ctrl_c_ends_a_run_and_not_the_interpreter(call):
    command = [sys.executable, "-c", INTERRUPTED.format(call=call), str(ENGINE), str(RING)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout.readline() == "begin\n"
        time.sleep(2)
        sent = time.time()
        process.send_signal(signal.SIGINT)
        words = process.stdout.readline().split()
        assert words[0] == "interrupted"
        print(f"{float(words[1]) - sent:.3f} s from Ctrl-C to KeyboardInterrupt")
        # Far less than what is left of the run; how fast it is docs/performance.md says.
        assert float(words[1]) - sent < 10
        assert float(process.stdout.readline()) == ow.solve(RING)["load"].value
    assert process.returncode == 0


def test_thousands_of_runs_leave_nothing_behind():
    before = threads_of_process()
    for _ in range(200):
        ow.solve(RING, bars=False, threads=2)
    assert threads_of_process() <= before + 2


def threads_of_process():
    return len(os.listdir("/proc/self/task"))


def test_the_module_links_no_python():
    module = next(Path(ow.__file__).parent.glob("_native*.so"))
    assert ".abi3." in module.name
    linked = subprocess.run(["ldd", module], capture_output=True, text=True, check=True).stdout
    assert "libpython" not in linked
    assert (Path(ow.__file__).parent / "py.typed").exists()


def test_types_hold(tmp_path):
    """Examples are checked strictly, and the stubs against the module."""
    checks = [[sys.executable, "-m", "mypy", "--strict", str(REPOSITORY / "crates/python/examples")]]
    # Some of the packages that tables and films are for have no types.
    (tmp_path / "mypy.ini").write_text("[mypy]\nignore_missing_imports = True\n[mypy-pandas.*]\nignore_missing_imports = True\n")
    (tmp_path / "allowed").write_text("oilwedge\\..*\\.(meshio|pandas|pyarrow|pyvista|xarray)\n")
    stubtest = ["mypy.stubtest", "oilwedge", "--mypy-config-file", "mypy.ini", "--allowlist", "allowed"]
    checks.append([sys.executable, "-m", *stubtest])
    for check in checks:
        ended = subprocess.run(check, capture_output=True, text=True, cwd=tmp_path)
        assert ended.returncode == 0, ended.stdout + ended.stderr
