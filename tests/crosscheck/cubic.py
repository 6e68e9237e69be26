"""The film of `film.py` in scikit-fem's cubic triangles, on the same (curved) quadratic geometry.

Swift-Stieber films are bounded at all ten nodes of a triangle, none of whose functions has a negative mean, and solved
by a primal-dual active set. At the end the conditions of the least functional are checked; only one film meets them,
however it was found.
"""

from dataclasses import dataclass

import numpy as np
import skfem
from scipy.sparse import coo_matrix, csr_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from film import Film, barus_pressure, curve_area, cut_out_share, reduced_pressure, rule_of_degree, solve_symmetric
from liner_mesh import read_liner
from obstacle import factorised

STEPS = 60


@dataclass
class CubicSolution:
    """What follows from the film (load N, two components; Int p dA N; Pa)."""

    load: np.ndarray
    pressure_integral: float
    pressure_max: float


def solve_cubic(scene, rule=None):
    """Solve a scene in cubic triangles; without a rule that of degree 8, which the program has too."""
    mesh = read_liner(scene.mesh, scene.radius, scene.holes())
    film = CubicFilm(scene, mesh, rule or rule_of_degree(8))
    q = film.solve_reduced_pressure()
    pressure = barus_pressure(film.at_points(q), scene.barus)
    load = film.film_share(pressure) + cut_out_share(scene, mesh)
    integral = np.sum(pressure * film.basis.dx) + cut_out_integral(scene, mesh)
    return CubicSolution(load, integral, barus_pressure(film.greatest(q), scene.barus))


def cut_out_integral(scene, mesh):
    """Int p dA over the regions cut out of the mesh [N]."""
    cut_out = [feed for feed in scene.feeds if feed.group in mesh.curves]
    areas = [np.pi * f.hole.radius**2 if f.hole else curve_area(mesh, f.group) for f in cut_out]
    return sum(feed.pressure * area for feed, area in zip(cut_out, areas))


class CubicFilm(Film):
    """Dofs are those of scikit-fem; `unknown` numbers them with the two sides of a seam glued."""

    def __init__(self, scene, mesh, rule):
        self.scene, self.mesh, self.solver = scene, mesh, solve_symmetric
        cells, self.vertices = ascending(mesh.cells), np.unique(mesh.cells[:, :3])
        grid = skfem.MeshTri2(np.ascontiguousarray(mesh.points.T), np.ascontiguousarray(cells.T))
        self.basis = skfem.Basis(grid, skfem.ElementTriP3(), quadrature=rule)
        self.node = np.arange(self.basis.N)
        self.unknown = self._unknowns()
        shape = (self.basis.N, self.unknown.max() + 1)
        self.glue = csr_matrix((np.ones(self.basis.N), (self.node, self.unknown)), shape=shape)
        self.fixed = self._given_pressures()
        self.stiffness = self.glue.T @ self._conductance() @ self.glue

    def _unknowns(self):
        """Dofs at one place of the cylinder are one if the mesh is glued at all."""
        if self.mesh.unknown.max() + 1 == len(self.mesh.points):
            return self.node
        x, z = self.basis.doflocs
        radius = self.scene.radius
        places = np.column_stack([radius * np.cos(x / radius), radius * np.sin(x / radius), z])
        pairs = cKDTree(places).query_pairs(1e-8 * radius, output_type="ndarray")
        graph = coo_matrix((np.ones(len(pairs)), pairs.T), shape=(self.basis.N, self.basis.N))
        count, unknown = connected_components(graph, directed=False)
        quadratic = self.mesh.unknown.max() + 1
        corners = len(np.unique(self.mesh.unknown[self.vertices]))
        # A vertex has one unknown in both, an edge one and two, a triangle none and one.
        assert count == corners + 2 * (quadratic - corners) + len(self.mesh.cells)
        return unknown

    def _given_pressures(self):
        scene, mesh, fixed = self.scene, self.mesh, {}

        def give(dofs, pressure):
            fixed.update(dict.fromkeys(self.unknown[dofs].ravel().tolist(), pressure))

        for group in ("end_low", "end_high", "arc_from", "arc_to"):
            if group in mesh.curves:
                give(self._edge_dofs(mesh.curves[group]), scene.end_pressure)
        if scene.film_start is not None:
            turn = self.basis.doflocs[0] / scene.radius - scene.film_start
            give(np.flatnonzero(np.abs(np.angle(np.exp(1j * turn))) < 1e-8), scene.end_pressure)
        for feed in scene.feeds:
            if feed.group in mesh.curves:
                give(self._edge_dofs(mesh.curves[feed.group]), feed.pressure)
            else:
                give(self.basis.element_dofs[:, mesh.surfaces[feed.group]], feed.pressure)
        return fixed

    def _edge_dofs(self, edges):
        """All dofs of edges of `mesh`, those of their ends among them."""
        ends = np.sort(np.searchsorted(self.vertices, edges[:, :2]), axis=1)
        number = {tuple(pair): k for k, pair in enumerate(self.basis.mesh.facets.T.tolist())}
        facets = [number[tuple(pair)] for pair in ends.tolist()]
        dofs = self.basis.dofs
        return np.concatenate([dofs.nodal_dofs[0, ends.ravel()], dofs.facet_dofs[:, facets].ravel()])

    def solve_reduced_pressure(self):
        """q at the dofs."""
        scene = self.scene
        fixed = {i: reduced_pressure(p, scene.barus) for i, p in self.fixed.items()}
        if scene.cavitation == "reynolds":
            lower = reduced_pressure(scene.cavitation_pressure, scene.barus)
            return solve_bounded_everywhere(self.stiffness, self._couette(), lower, fixed)[self.unknown]
        return self._solve_linear(self.stiffness, self._couette(), fixed)[self.unknown]

    def greatest(self, q):
        """The greatest value of the polynomials, between nodes too: around each high triangle's best point ever
        closer."""
        values = q[self.basis.element_dofs]
        lattice = np.array([(i, j) for i in range(13) for j in range(13 - i)]) / 12
        high = np.flatnonzero(values.max(axis=0) >= values.max() - 0.02 * np.ptp(values))
        return max(self._greatest_of(values[:, cell], lattice) for cell in high)

    def _greatest_of(self, nodal, lattice):
        points, size = lattice, 1.0
        square = np.array([(i, j) for i in range(-4, 5) for j in range(-4, 5)]) / 4
        while True:
            shapes = [self.basis.elem.lbasis(points.T, i)[0] for i in range(10)]
            field = nodal @ np.array(shapes)
            if size < 1e-7:
                return field.max()
            size /= 3
            best = points[np.argmax(field)]
            points = np.vstack([best, best + size * square])
            points = points[(points.min(axis=1) >= 0) & (points.sum(axis=1) <= 1)]
            # Along the slanting edge the square has no points but by chance: put those beyond it onto it.
            beyond = best + size * square
            beyond = beyond[(beyond.sum(axis=1) > 1) & (beyond.min(axis=1) >= 0)]
            points = np.vstack([points, beyond / beyond.sum(axis=1, keepdims=True)])


def ascending(cells):
    """Cells with their vertices in ascending order: scikit-fem's two functions of an edge run from its lesser end."""
    order = np.argsort(cells[:, :3], axis=1)
    corners = np.take_along_axis(cells[:, :3], order, axis=1)
    middle = np.array([[-1, 3, 5], [3, -1, 4], [5, 4, -1]])  # local node between two local vertices
    middles = [
        np.take_along_axis(cells, middle[order[:, a], order[:, b]][:, None], axis=1) for a, b in ((0, 1), (1, 2), (2, 0))
    ]
    return np.hstack([corners, *middles])


def solve_bounded_everywhere(matrix, right, lower, fixed):
    """The least of x.A x/2 - b.x among all x >= lower with the values in `fixed`, by a primal-dual active set."""
    known = np.fromiter(fixed.keys(), int)
    x = np.zeros(len(right))
    x[known] = np.fromiter(fixed.values(), float)
    open_ = np.ones(len(x), bool)
    open_[known] = False
    held = np.zeros(len(x), bool)
    matrix = matrix.tocsr()
    scale = matrix.diagonal().mean()
    seen = set()
    for _ in range(STEPS):
        free = np.flatnonzero(open_ & ~held)
        x[held], x[free] = lower, 0.0
        x[free] = factorised(matrix[free][:, free])((right - matrix @ x)[free])
        force = np.where(held, matrix @ x - right, 0.0)
        next_held = open_ & (force - scale * (x - lower) > 0)
        if (next_held == held).all():
            size = np.abs(x - lower).max()
            assert (x[open_] - lower).min() >= -1e-13 * size and force.min() >= 0
            return x
        key = next_held.tobytes()
        assert key not in seen, "the active set goes round in circles"
        seen.add(key)
        held = next_held
    raise RuntimeError("the active set did not settle")
