"""The snippets of docs/reference do what the pages say."""

import re
import subprocess

import gmsh
import pytest
import pyvista

from oilwedge_run import REPOSITORY, SCENES, program, quantity, solve, written
from scene_file import write_variant


def snippet(page, language):
    """The one block of a page in this language."""
    text = (REPOSITORY / "docs" / "reference" / page).read_text()
    (found,) = re.findall(rf"```{language}\n(.*?)```", text, flags=re.DOTALL)
    return found


def test_geo_of_the_mesh_page_makes_a_ring(tmp_path):
    (tmp_path / "ring.geo").write_text(snippet("mesh_files.md", "geo"))
    gmsh.initialize()
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.open(str(tmp_path / "ring.geo"))
        gmsh.model.mesh.generate(2)
        gmsh.write(str(tmp_path / "ring.msh"))
    finally:
        gmsh.finalize()
    check = [program("OILWEDGE_BIN", "oilwedge"), "check", str(tmp_path / "ring.msh")]
    assert "can be used" in subprocess.run(check, check=True, capture_output=True, text=True).stdout
    scene = write_variant(SCENES / "01_plain_ring.toml", tmp_path / "scene.toml", mesh=tmp_path / "ring.msh")
    result, _ = solve(scene, unrolled=False)
    # Scene 01 on its own mesh; both are off by some 1e-5.
    assert quantity(result, "load") == pytest.approx(43566.717969, rel=1e-4)


def test_pyvista_snippet_of_the_result_page_runs(tmp_path, monkeypatch, capsys):
    result, _ = written(SCENES / "02_flexpde_shell.toml", tmp_path / "out/02_flexpde_shell", unrolled=False)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(pyvista, "OFF_SCREEN", True)
    code = snippet("result.md", "python")
    assert len(code.splitlines()) == 5
    exec(code, {})
    greatest, thinnest = map(float, capsys.readouterr().out.split())
    assert greatest == pytest.approx(quantity(result, "pressure_max"), rel=1e-3)
    assert thinnest == pytest.approx(quantity(result, "film_thickness_min"), rel=1e-3)
