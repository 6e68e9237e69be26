"""Make a big mesh for timing: a ring with one feed hole, straight 3-node triangles, binary file.

    python benchmark.py N_UNKNOWNS OUT.msh

N_UNKNOWNS is the number of nodes of the quadratic (P2) problem, met within a few per cent.
"""

import sys
from pathlib import Path

import gmsh

AREA = 2 * 3.141592653589793 * 0.0375 * 0.075  # m2


def mesh_with_size(size):
    """Mesh the ring with this cell size [m]; returns the number of P2 nodes."""
    gmsh.clear()
    gmsh.open(str(Path(__file__).with_name("flexpde_ring.geo")))
    uniform = gmsh.model.mesh.field.add("MathEval")
    gmsh.model.mesh.field.setString(uniform, "F", f"{size:.9g}")
    gmsh.model.mesh.field.setAsBackgroundMesh(uniform)
    gmsh.option.setNumber("Mesh.ElementOrder", 1)
    gmsh.model.mesh.generate(2)
    triangles = len(gmsh.model.mesh.getElementsByType(2)[0])
    lines = len(gmsh.model.mesh.getElementsByType(1)[0])
    return 2 * triangles + lines  # P2 nodes of a rectangle with one hole (Euler)


def main(unknowns, path):
    gmsh.initialize()
    gmsh.option.setNumber("General.Verbosity", 2)
    size = (4 * AREA / (3**0.5 * unknowns / 2)) ** 0.5  # equilateral cells, two nodes a cell
    trial = min(unknowns, 20000)
    trial_size = size * (unknowns / trial) ** 0.5
    size *= (mesh_with_size(trial_size) / trial) ** 0.5
    nodes = mesh_with_size(size)
    gmsh.option.setNumber("Mesh.Binary", 1)
    gmsh.write(path)
    gmsh.finalize()
    print(f"{nodes} P2 nodes (asked for {unknowns}), cell size {size:.3g} m")


if __name__ == "__main__":
    main(int(sys.argv[1]), sys.argv[2])
