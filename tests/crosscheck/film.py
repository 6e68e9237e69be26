"""Reynolds' equation on a liner with scikit-fem's quadratic triangles: an independent second answer.

    constant viscosity, Barus:  div( h^3/(12 mu0) grad q ) = div( U h/2 ) + dh/dt,
                                q = (1 - exp(-alpha p))/alpha   (q = p at alpha = 0)
    as the study prints it:     div( h^3/(12 mu0) grad p ) = div( U h/2 ) + (exp(alpha p) - 1) div( U h/2 )

Full Sommerfeld film, or one that cavitates after Swift and Stieber: then q is the least of
Int h^3/(12 mu0) |grad q|^2/2 - (U h/2) dq/dx + dh/dt q  among all q >= q(p_c) (`obstacle.py`), where the
bound holds at edge midpoints, the degrees of freedom whose shape functions have a positive mean.

Pressure is given on the ends, the edges of an arc, the line of a film start and the feeds; a ring is
periodic. Every integral over cells uses the quadrature rule that is passed in:
(points (2, k), weights (k,)) on the reference triangle (0,0), (1,0), (0,1).
"""

from dataclasses import dataclass

import numpy as np
import skfem
from scipy.sparse import csr_matrix
from scipy.spatial import cKDTree
from scipy.special import j1

from liner_mesh import LinerMesh, read_liner, refined
from obstacle import factorised, solve_bounded

EDGE_RULE = np.polynomial.legendre.leggauss(8)


@dataclass
class FilmSolution:
    """Pressures at the nodes of `mesh` [Pa] and what follows from them (N, rad, -)."""

    mesh: LinerMesh
    pressure: np.ndarray
    load_x: float
    load_y: float
    load: float
    load_angle: float
    attitude_angle: float
    load_coefficient: float | None


def rule_of_degree(degree):
    """scikit-fem's quadrature rule that is exact for polynomials of this degree."""
    return skfem.quadrature.get_quadrature_tri(degree)


def solve_symmetric(matrix, right):
    return factorised(matrix)(right)


def solve_film(scene, rule, refinements=0, solver=solve_symmetric):
    """Solve a scene (see `scene_file.Scene`) with a quadrature rule, on its mesh refined so many times.

    solver(matrix, right) solves linear systems; the matrix is symmetric."""
    mesh = read_liner(scene.mesh, scene.radius, scene.holes())
    for _ in range(refinements):
        mesh = refined(mesh, scene.radius, scene.holes())
    film = Film(scene, mesh, rule, solver)
    if scene.cavitation not in ("none", "reynolds") or (scene.as_printed and scene.cavitation != "none"):
        raise NotImplementedError(scene.cavitation)
    if scene.as_printed:
        nodal = film.solve_as_printed()
        pressure_at_points = film.at_points(nodal)
        pressure = nodal
    else:
        nodal = film.solve_reduced_pressure()
        pressure_at_points = barus_pressure(film.at_points(nodal), scene.barus)
        pressure = barus_pressure(nodal, scene.barus)
    load = film.film_share(pressure_at_points) + cut_out_share(scene, mesh)
    return _solution(scene, mesh, pressure, load)


def reduced_pressure(p, alpha):
    """q = (1 - exp(-alpha p))/alpha [Pa]."""
    return -np.expm1(-alpha * p) / alpha if alpha else p


def barus_pressure(q, alpha):
    """p = -ln(1 - alpha q)/alpha [Pa]."""
    return -np.log1p(-alpha * q) / alpha if alpha else q


class Film:
    """Discrete film: basis with the given rule, seam glued, Dirichlet values known."""

    def __init__(self, scene, mesh, rule, solver=solve_symmetric):
        self.scene, self.mesh, self.solver = scene, mesh, solver
        self.basis = skfem.Basis(_skfem_mesh(mesh), skfem.ElementTriP2(), quadrature=rule)
        self.node = _nodes_of_dofs(self.basis, mesh)
        count = mesh.unknown.max() + 1
        dofs = np.arange(self.basis.N)
        # Columns are unknowns, rows are dofs: glues the two sides of a seam.
        self.glue = csr_matrix(
            (np.ones(len(dofs)), (dofs, mesh.unknown[self.node])), shape=(len(dofs), count)
        )
        self.fixed = given_pressures(scene, mesh)
        self.stiffness = self.glue.T @ self._conductance() @ self.glue

    def _conductance(self):
        @skfem.BilinearForm
        def form(q, v, w):
            return w.conductance * (q.grad[0] * v.grad[0] + q.grad[1] * v.grad[1])

        h = self.scene.film_thickness(*self.basis.global_coordinates())
        return form.assemble(self.basis, conductance=h**3 / (12 * self.scene.viscosity))

    def _couette(self):
        """Int U h/2 dv/dx - dh/dt v."""
        scene, places = self.scene, self.basis.global_coordinates()

        @skfem.LinearForm
        def form(v, w):
            return w.drag * v.grad[0] - w.rate * v

        drag = scene.speed * scene.radius / 2 * scene.film_thickness(*places)
        return self.glue.T @ form.assemble(self.basis, drag=drag, rate=scene.thickness_rate(*places))

    def _printed_source(self, p):
        """s = Int (exp(alpha p) - 1) U/2 dh/dx v and its derivative ds/dp: the oil that the printed form makes."""
        scene = self.scene
        pressure = np.asarray(self.basis.interpolate(self.glue @ p))
        phi = self.basis.global_coordinates()[0] / scene.radius - scene.min_film_angle
        slope = scene.clearance * scene.eccentricity * np.sin(phi) / scene.radius
        drag = scene.speed * scene.radius / 2 * slope
        made = np.expm1(scene.barus * pressure) * drag
        growth = scene.barus * np.exp(scene.barus * pressure) * drag
        vector = skfem.LinearForm(lambda v, w: w.made * v).assemble(self.basis, made=made)
        matrix = skfem.BilinearForm(lambda u, v, w: w.growth * u * v).assemble(self.basis, growth=growth)
        return self.glue.T @ vector, self.glue.T @ matrix @ self.glue

    def _solve_linear(self, matrix, right, fixed):
        """Solve with the unknowns in `fixed` (number -> value) held."""
        known = np.fromiter(fixed.keys(), int)
        free = np.setdiff1d(np.arange(len(right)), known)
        x = np.zeros(len(right))
        x[known] = np.fromiter(fixed.values(), float)
        matrix = matrix.tocsr()
        reduced = (right - matrix @ x)[free]
        x[free] = self.solver(matrix[free][:, free].tocsc(), reduced)
        return x

    def solve_reduced_pressure(self):
        """Nodal q of the conservative problem, which is linear but for cavitation."""
        alpha = self.scene.barus
        fixed = {i: reduced_pressure(p, alpha) for i, p in self.fixed.items()}
        if self.scene.cavitation == "reynolds":
            lower = reduced_pressure(self.scene.cavitation_pressure, alpha)
            middles = np.unique(self.mesh.unknown[self.mesh.cells[:, 3:]])
            q, _ = solve_bounded(self.stiffness, self._couette(), lower, middles, fixed)
            return q[self.mesh.unknown]
        return self._solve_linear(self.stiffness, self._couette(), fixed)[self.mesh.unknown]

    def solve_as_printed(self, steps=30):
        """Nodal p of the printed equation by Newton's method from the isoviscous film."""
        couette = self._couette()
        p = self._solve_linear(self.stiffness, couette, self.fixed)
        held = dict.fromkeys(self.fixed, 0.0)
        for _ in range(steps):
            source, tangent = self._printed_source(p)
            change = self._solve_linear(self.stiffness + tangent, couette - self.stiffness @ p - source, held)
            p = p + change
            if np.abs(change).max() < 1e-13 * np.abs(p).max():
                return p[self.mesh.unknown]
        raise RuntimeError("Newton's method did not converge")

    def at_points(self, nodal):
        """Values of the quadratic interpolant at the quadrature points (cells, points)."""
        return np.asarray(self.basis.interpolate(nodal[self.node]))

    def film_share(self, pressure):
        """Int (p - p_e)(cos phi, sin phi) dA over the meshed cells [N]."""
        phi = self.basis.global_coordinates()[0] / self.scene.radius
        density = (pressure - self.scene.end_pressure) * self.basis.dx
        return np.array([np.sum(density * np.cos(phi)), np.sum(density * np.sin(phi))])


def _skfem_mesh(mesh):
    if mesh.straight:
        vertices, cells = np.unique(mesh.cells[:, :3], return_inverse=True)
        points, kind = mesh.points[vertices], skfem.MeshTri1
    else:
        points, cells, kind = mesh.points, mesh.cells, skfem.MeshTri2
    return kind(np.ascontiguousarray(points.T), np.ascontiguousarray(cells.T))


def _nodes_of_dofs(basis, mesh):
    """Node of the liner mesh at the place of each dof of scikit-fem."""
    distance, node = cKDTree(mesh.points).query(basis.doflocs.T)
    assert distance.max() < 1e-9 * np.ptp(mesh.points), "dofs and nodes do not match"
    assert len(np.unique(node)) == len(node) == len(mesh.points)
    return node


def given_pressures(scene, mesh):
    """Pressure [Pa] by number of unknown: ends, edges of an arc, film start, feeds."""
    fixed = {}
    for group in ("end_low", "end_high", "arc_from", "arc_to"):
        if group in mesh.curves:
            fixed |= dict.fromkeys(mesh.unknown[mesh.curves[group]].ravel(), scene.end_pressure)
    if scene.film_start is not None:
        turn = mesh.points[:, 0] / scene.radius - scene.film_start
        on_line = np.abs(np.angle(np.exp(1j * turn))) < 1e-8
        fixed |= dict.fromkeys(mesh.unknown[on_line], scene.end_pressure)
    for feed in scene.feeds:
        cut_out = feed.group in mesh.curves
        nodes = mesh.curves[feed.group] if cut_out else mesh.cells[mesh.surfaces[feed.group]]
        fixed |= dict.fromkeys(mesh.unknown[nodes].ravel(), feed.pressure)
    return fixed


def cut_out_share(scene, mesh):
    """Load of the regions cut out of the mesh, (p_f - p_e) Int (cos phi, sin phi) dA [N]."""
    share = np.zeros(2)
    for feed in scene.feeds:
        if feed.group in mesh.curves:
            if feed.hole:
                integral = disc_integral(feed.hole, scene.radius)
            else:
                integral = curve_integral(mesh, feed.group, scene.radius)
            share += (feed.pressure - scene.end_pressure) * integral
    return share


def disc_integral(hole, radius):
    """Int (cos phi, sin phi) dA over a disc of radius a: 2 pi a R J1(a/R) (cos phi_0, sin phi_0) [m2]."""
    phi = hole.x / radius
    size = 2 * np.pi * hole.radius * radius * j1(hole.radius / radius)
    return size * np.array([np.cos(phi), np.sin(phi)])


def curve_integral(mesh, group, radius):
    """The same over the region inside a closed curve of edges, R loop-Int (sin phi, -cos phi) dz.

    The film is on the left of the edges, so the region's own sense is the opposite one.
    """
    start, end, middle = (mesh.points[mesh.curves[group][:, k]] for k in range(3))
    total = np.zeros(2)
    for s, weight in zip(*EDGE_RULE):
        place = s * (s - 1) / 2 * start + s * (s + 1) / 2 * end + (1 - s**2) * middle
        dz = ((s - 0.5) * start + (s + 0.5) * end - 2 * s * middle)[:, 1]
        phi = place[:, 0] / radius
        total -= weight * radius * np.array([np.sum(np.sin(phi) * dz), np.sum(-np.cos(phi) * dz)])
    return total


def curve_area(mesh, group):
    """Area [m2] of the region inside a closed curve of edges: x dz is a cubic along each, so Simpson's rule is
    exact."""
    start, end, middle = (mesh.points[mesh.curves[group][:, k]] for k in range(3))
    slopes = (4 * middle - 3 * start - end, end - start, 3 * end + start - 4 * middle)  # by t at t = 0, 1/2, 1
    return -sum(
        weight * np.sum(place[:, 0] * slope[:, 1])
        for place, slope, weight in zip((start, middle, end), slopes, (1 / 6, 2 / 3, 1 / 6))
    )


def _solution(scene, mesh, pressure, load):
    size, angle = np.hypot(*load), np.arctan2(load[1], load[0])
    attitude = np.angle(np.exp(1j * (scene.min_film_angle - angle))) * (-1 if scene.speed < 0 else 1)
    coefficient = None
    if len({feed.pressure for feed in scene.feeds}) == 1:
        head = scene.feeds[0].pressure - scene.end_pressure
        coefficient = size / (2 * scene.length * scene.radius * head)
    return FilmSolution(mesh, pressure, *load, size, angle, attitude, coefficient)
