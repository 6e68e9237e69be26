"""What the Python package refuses, and what has no answer: the words are those of the terminal."""

import json
import pickle

import numpy as np
import oilwedge as ow
import pytest

from oilwedge_run import REPOSITORY, SCENES
from python_package import ENGINE, RING, SHELL, run

WRONG = json.loads((REPOSITORY / "tests/data/wrong_scenes.json").read_text())
# Pressure-dependent viscosity above its limit.
NO_FILM = {"oil.barus.alpha": "1e-5 1/Pa", "journal.eccentricity": 0.9}


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


@pytest.mark.parametrize(
    "wrong",
    (
        {"max_seconds": 0},
        {"max_seconds": float("nan")},
        {"max_seconds": "a"},
        {"max_unknowns": 0},
        {"max_unknowns": 1e6},
        {"threads": 0},
        {"threads": 1.5},
    ),
)
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
