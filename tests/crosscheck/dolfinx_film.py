"""The film of `compare_speed.py` by DOLFINx: CPU seconds from the mesh file to the load, on one thread.

    /usr/bin/python3 dolfinx_film.py RING.msh        (Debian: python3-dolfinx, python3-gmsh)

Quadratic elements on a closed ring of straight triangles, conjugate gradients with hypre's BoomerAMG to a residual of
1e-10. The forms are compiled before the clock starts. Triangles are chords of the cylinder here, so the load differs by
the square of the cell size. Prints the seconds and the load [N].
"""

import os

os.environ["OMP_NUM_THREADS"] = "1"

import statistics
import sys
import time

import gmsh
import numpy as np
import ufl
from dolfinx import fem, mesh
from dolfinx.fem import petsc
from mpi4py import MPI
from petsc4py import PETSc

RADIUS, LENGTH, CLEARANCE = 0.0375, 0.075, 37.5e-6
ECCENTRICITY, OMEGA, VISCOSITY, FEED = 0.8, 10.0, 0.4, 1e5
RUNS = 3


def read(path):
    """The ring closed at its seam: points on the cylinder [m], triangles."""
    gmsh.initialize()
    gmsh.option.setNumber("General.Verbosity", 0)
    gmsh.open(path)
    tags, points, _ = gmsh.model.mesh.getNodes()
    _, corners = gmsh.model.mesh.getElementsByType(2)
    gmsh.finalize()
    number = np.zeros(int(tags.max()) + 1, dtype=np.int64)
    number[tags] = np.arange(len(tags))
    x, z = points.reshape(-1, 3)[:, :2].T
    angle = x / RADIUS
    seam_low = np.flatnonzero(np.abs(angle) < 1e-9)
    seam_high = np.flatnonzero(np.abs(angle - 2 * np.pi) < 1e-9)
    same = np.arange(len(x))
    same[seam_high[np.argsort(z[seam_high])]] = seam_low[np.argsort(z[seam_low])]
    kept, places = np.unique(same, return_inverse=True)
    on_cylinder = np.column_stack([RADIUS * np.cos(angle), RADIUS * np.sin(angle), z])
    return on_cylinder[kept], places[number[corners.astype(np.int64)]].reshape(-1, 3)


def solve(path):
    """The load [N]."""
    points, triangles = read(path)
    domain = ufl.Mesh(ufl.VectorElement("Lagrange", ufl.Cell("triangle", geometric_dimension=3), 1))
    ring = mesh.create_mesh(MPI.COMM_SELF, triangles, points, domain)
    space = fem.FunctionSpace(ring, ("Lagrange", 2))
    p, v, x = ufl.TrialFunction(space), ufl.TestFunction(space), ufl.SpatialCoordinate(ring)
    radius = ufl.sqrt(x[0] ** 2 + x[1] ** 2)
    normal = ufl.as_vector([x[0] / radius, x[1] / radius, 0.0])
    around = ufl.as_vector([-normal[1], normal[0], 0.0])
    h = CLEARANCE * (1 + ECCENTRICITY * normal[0])
    rule = {"quadrature_degree": 6}
    matrix = fem.form(h**3 / (12 * VISCOSITY) * ufl.dot(ufl.grad(p), ufl.grad(v)) * ufl.dx(metadata=rule))
    right = fem.form(0.5 * OMEGA * RADIUS * h * ufl.dot(around, ufl.grad(v)) * ufl.dx(metadata=rule))
    ring.topology.create_connectivity(1, 2)
    at_ends = mesh.locate_entities_boundary(ring, 1, lambda x: np.abs(np.abs(x[2]) - 0.5 * LENGTH) < 1e-9)
    rims = np.setdiff1d(mesh.exterior_facet_indices(ring.topology), at_ends)
    given = [
        fem.dirichletbc(PETSc.ScalarType(value), fem.locate_dofs_topological(space, 1, facets), space)
        for value, facets in ((0.0, at_ends), (FEED, rims))
    ]
    stiffness = petsc.assemble_matrix(matrix, bcs=given)
    stiffness.assemble()
    load_vector = petsc.assemble_vector(right)
    petsc.apply_lifting(load_vector, [matrix], [given])
    petsc.set_bc(load_vector, given)
    pressure = fem.Function(space)
    solver = PETSc.KSP().create(MPI.COMM_SELF)
    solver.setOperators(stiffness)
    solver.setType("cg")
    solver.getPC().setType("hypre")
    solver.setTolerances(rtol=1e-10)
    solver.solve(load_vector, pressure.vector)
    if solver.getConvergedReason() < 0:
        raise RuntimeError("the conjugate gradients do not converge")
    force = [fem.assemble_scalar(fem.form(pressure * normal[d] * ufl.dx(metadata=rule))) for d in (0, 1)]
    return float(np.hypot(*force)), space.dofmap.index_map.size_global


def main(path):
    solve(path)
    seconds = []
    for _ in range(RUNS):
        before = time.process_time()
        load, unknowns = solve(path)
        seconds.append(time.process_time() - before)
    print(statistics.median(seconds), load, unknowns)


if __name__ == "__main__":
    main(sys.argv[1])
