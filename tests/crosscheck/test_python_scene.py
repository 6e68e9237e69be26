"""Scenes of the Python package: made of a file, a mapping or another scene."""

import pickle

import numpy as np
import oilwedge as ow
import pytest

from oilwedge_run import SCENES
from python_package import RING, run


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


def test_other_values_may_have_tolerances():
    scene = ow.Scene.new("plain") | {"bearing.clearance": "27 um +- 3 um", "oil.viscosity": "18 mPa.s .. 22 mPa.s"}
    assert 'clearance = "27 um +- 3 um"' in scene.text
    result = ow.solve(scene, bars=False)
    assert {"bearing.clearance", "oil.viscosity"} <= set(result.spread.columns)
    with pytest.raises(ow.SceneError, match="has a tolerance"):
        scene | {"mesh.size": "2 mm +- 1 mm"}


@pytest.mark.parametrize(
    ("changes", "key", "words"),
    [
        ({"jurnal.speed": "3000 rpm"}, "jurnal.speed", "no table of a scene"),
        ({"sped": "3000 rpm"}, "sped", "not known"),
        ({"journal.speed": 3000}, "journal.speed", "bare number"),
        ({"journal": {"speed": "3000 rpm"}}, "journal", "is a table"),
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


class Endless:
    """Makes another one of itself for ever."""

    def tolist(self):
        return Endless()


def in_itself():
    table = {}
    table["a"] = table
    return table


@pytest.mark.parametrize(
    ("wrong", "words"),
    (
        ({"title": None}, "title: a NoneType"),
        ({"journal": {"speed": {1, 2}}}, "journal.speed: a set"),
        ({1: 2}, "the key 1 is no text"),
        (None, "a scene is made of a mapping"),
        ("bearing.toml", "Scene.read reads a file"),
        (in_itself(), "more than 64 deep"),
        ({"title": Endless()}, "title: lists and dicts lie more than 64 deep"),
    ),
)
def test_what_toml_cannot_hold_is_refused(wrong, words):
    with pytest.raises(TypeError, match=words):
        ow.Scene(wrong)


def test_a_number_of_too_many_digits_is_refused():
    with pytest.raises(ValueError, match="title: the whole number 1000"):
        ow.Scene({"title": 10**30})
