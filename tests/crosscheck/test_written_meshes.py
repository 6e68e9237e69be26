"""gmsh opens the meshes that oilwedge writes, and finds in them what oilwedge says is there."""

import re
import subprocess

import gmsh
import pytest

from oilwedge_run import SCENES, program

SCENES_AND_GROUPS = {
    "10_drawn_liner": {"film", "end_low", "end_high", "seam_low", "seam_high", "groove", "hole_a", "hole_b"},
    "02_flexpde_shell": {"film", "end_low", "end_high", "arc_from", "arc_to", "feed_hole"},
}


@pytest.mark.parametrize("scene, groups", SCENES_AND_GROUPS.items())
def test_gmsh_reads_a_written_mesh(scene, groups, tmp_path):
    path = tmp_path / "liner.msh"
    command = [program("OILWEDGE_BIN", "oilwedge"), "mesh", str(SCENES / f"{scene}.toml"), "-o", str(path)]
    told = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    triangles, nodes = map(int, re.search(r"(\d+) triangles, (\d+) nodes", told).groups())
    gmsh.initialize()
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.open(str(path))
        names = {gmsh.model.getPhysicalName(*group) for group in gmsh.model.getPhysicalGroups()}
        tags, coordinates, _ = gmsh.model.mesh.getNodes()
        kinds, elements, _ = gmsh.model.mesh.getElements(dim=2)
    finally:
        gmsh.finalize()
    assert names == groups
    assert list(kinds) == [9] and len(elements[0]) == triangles
    # On an unrolled ring the nodes of the seam stand on both sides.
    assert (len(tags) > nodes) == ("seam_low" in groups)
    assert len(coordinates) == 3 * len(tags)
