"""Mass-conserving cavitation (Jakobsson, Floberg, Olsson; Elrod, Adams) on a grid along the flow.

    div J = 0,   J = (U h theta / 2, 0) - h^3/(12 mu) grad p,   p >= 0,  theta <= 1,  p (1 - theta) = 0

with p above the cavitation pressure. Finite volumes around the nodes of a rectangular grid in x and z. Oil is
dragged along the grid lines, so taking theta from upstream smears nothing across the flow: the edges of streaks
behind a supply stay sharp. The film thickness is asked for between nodes only, so it may jump at nodes.

Symmetric about z = 0 (the grid covers z >= 0), or one-dimensional with a single row.
"""

from dataclasses import dataclass

import numpy as np
from scipy.sparse import csr_matrix, diags_array
from scipy.sparse.linalg import splu

ITERATIONS = 200


@dataclass
class Film:
    """What is to be solved, SI units.

    x, z        node coordinates; z starts at the line of symmetry, z = [0] is one-dimensional
    period      length of a ring (then x[0] + period follows x[-1]), or None
    thickness   h(x), asked for off the nodes
    given       (nx, nz) pressures, NaN where free; theta = 1 is held where p is given above zero
    cut         (side, nx, nz) part of the link to the next node along x (side 0) or z (side 1) that lies in the film
    inlet       theta of the oil brought in at x[0] where no pressure is given (speed > 0), or None
    """

    x: np.ndarray
    z: np.ndarray
    period: float | None
    thickness: callable
    speed: float
    viscosity: float
    given: np.ndarray
    cut: np.ndarray | None = None
    inlet: float | None = None


@dataclass
class Solution:
    """Pressure and film fraction (nx, nz); inflow [m3/s] of half the width at nodes of given pressure."""

    film: Film
    pressure: np.ndarray
    theta: np.ndarray
    inflow: np.ndarray
    iterations: int

    def load(self, radius):
        """(W_x, W_y) [N] of the whole width: trapezoidal rule."""
        phi = self.film.x / radius
        force = 2 * self.pressure @ _widths(self.film.z) * _widths(self.film.x, self.film.period)
        return np.array([force @ np.cos(phi), force @ np.sin(phi)])


def solve(film, guess=None):
    """Active set: a full node whose pressure falls below zero cavitates, a cavity node that fills is full."""
    pressures, drag = _matrices(film)
    scale = np.abs(drag.data).max() / np.abs(pressures.data).max()
    given = film.given.ravel()
    free = np.isnan(given)
    held = np.where(free, 0.0, given) / scale
    brought = _brought(film)
    cavity = free & (guess.ravel() if guess is not None else False)
    seen = set()
    for iteration in range(1, ITERATIONS):
        full = (~cavity).astype(float)
        # One unknown a node: p where full, theta in the cavity. Given nodes: p and theta are known.
        matrix = (scale * pressures @ diags_array(full) + drag @ diags_array(1 - full)).tocsr()
        right = brought - drag @ full - scale * (pressures @ held)
        unknown = np.zeros(len(given))
        unknown[free] = splu(matrix[free][:, free].tocsc(), permc_spec="MMD_AT_PLUS_A").solve(right[free])
        p = np.where(cavity, 0.0, unknown + held)
        theta = np.where(cavity, unknown, 1.0)
        change = free & np.where(cavity, theta > 1 + 1e-12, p < 0)
        if not change.any():
            inflow = np.where(free, 0.0, scale * (pressures @ p) + drag @ theta)
            shape = film.given.shape
            return Solution(film, scale * p.reshape(shape), theta.reshape(shape), inflow.reshape(shape), iteration)
        cavity = cavity ^ change
        key = cavity.tobytes()
        assert key not in seen, "the active set repeats"
        seen.add(key)
    raise RuntimeError("the active set did not settle")


def _brought(film):
    """Oil that a starved inlet brings to each node."""
    brought = np.zeros(film.given.shape)
    if film.inlet is not None:
        brought[0] = film.inlet * film.speed / 2 * film.thickness(film.x[:1]) * _widths(film.z)
    return np.where(np.isnan(film.given), brought, 0.0).ravel()


def _widths(nodes, period=None):
    """Length that belongs to each node; a single node has length 1."""
    if len(nodes) == 1:
        return np.ones(1)
    if period:
        steps = np.diff(nodes, append=nodes[0] + period)
        return (steps + np.roll(steps, 1)) / 2
    steps = np.diff(nodes)
    return (np.append(steps, 0) + np.append(0, steps)) / 2


def _matrices(film):
    """Outflow of each cell from p and from theta."""
    nx, nz = film.given.shape
    number = np.arange(nx * nz).reshape(nx, nz)
    wx, wz = _widths(film.x, film.period), _widths(film.z)
    cut = np.ones((2, nx, nz)) if film.cut is None else film.cut
    left, right = number, np.roll(number, -1, axis=0)
    x_next = np.append(film.x[1:], film.x[0] + (film.period or 0.0))
    if not film.period:
        left, right, x_next = left[:-1], right[:-1], x_next[:-1]
    count = len(left)
    step = x_next - film.x[:count]
    h = film.thickness(film.x[:count] + step / 2)
    along = (h**3 / (12 * film.viscosity * step))[:, None] * wz / cut[0, :count]
    dragged = (film.speed / 2 * h)[:, None] * wz
    links, weights = [(left, right)], [along]
    if nz > 1:
        # h may jump at a node: each half of its cell counts with its own.
        before = np.roll(step, 1) if film.period else np.append(0.0, step)
        after = step if film.period else np.append(step, 0.0)
        cubes = film.thickness(film.x + after / 4) ** 3 * after + film.thickness(film.x - before / 4) ** 3 * before
        across = (cubes / (24 * film.viscosity))[:, None] / np.diff(film.z) / cut[1, :, :-1]
        links.append((number[:, :-1], number[:, 1:]))
        weights.append(across)
    rows, columns, values = [], [], []
    for (a, b), weight in zip(links, weights):
        rows += [a, b, a, b]
        columns += [a, b, b, a]
        values += [weight, weight, -weight, -weight]
    size = (nx * nz, nx * nz)
    upstream = left if film.speed > 0 else right
    return (
        _sparse(rows, columns, values, size),
        _sparse([left, right], [upstream, upstream], [dragged, -dragged], size),
    )


def _sparse(rows, columns, values, size):
    flat = [np.concatenate([np.ravel(part) for part in parts]) for parts in (values, rows, columns)]
    return csr_matrix((flat[0], (flat[1], flat[2])), shape=size)


@dataclass
class Bearing:
    """A ring with one supply region; film h = c (1 - eps cos phi), cavitation and ends at zero."""

    radius: float
    length: float
    clearance: float
    eccentricity: float
    viscosity: float
    speed: float  # rad/s

    def thickness(self, x):
        return self.clearance * (1 - self.eccentricity * np.cos(x / self.radius))

    def film(self, columns, rows, given, cut=None):
        x = 2 * np.pi * self.radius * np.arange(columns) / columns
        z = self.length / 2 * np.arange(rows + 1) / rows
        given = given(x[:, None], z[None, :])
        given[:, -1] = np.where(np.isnan(given[:, -1]), 0.0, given[:, -1])
        cut = None if cut is None else cut(x, z)
        turn = 2 * np.pi * self.radius
        return Film(x, z, turn, self.thickness, self.speed * self.radius, self.viscosity, given, cut)

    def with_groove(self, columns, rows, start, end, width, pressure):
        """Groove from one angle to the other [rad]; best with its edges on grid lines."""

        def given(x, z):
            near = 1e-9
            inside = (x > self.radius * start - near) & (x < self.radius * end + near) & (z < width / 2 + near)
            return np.where(inside, pressure, np.nan)

        return self.film(columns, rows, given)

    def with_hole(self, columns, rows, angle, radius, pressure):
        """Round hole at z = 0; links that cross its rim are shortened to the part in the film."""
        centre = self.radius * angle

        def given(x, z):
            return np.where(np.hypot(x - centre, z) < radius, pressure, np.nan)

        def cut(x, z):
            along, across = np.meshgrid(x - centre, z, indexing="ij")
            inside = np.hypot(along, across) < radius
            parts = []
            for axis, own, other in ((0, along, across), (1, across, along)):
                ahead = np.roll(own, -1, axis)
                crossing = inside ^ np.roll(inside, -1, axis)
                rim = np.sign(own + ahead) * np.sqrt(np.maximum(radius**2 - other**2, 0))
                outer = np.where(inside, ahead, own)
                part = np.abs(outer - rim) / np.abs(ahead - own)
                parts.append(np.where(crossing, np.maximum(part, 1e-6), 1.0))
            return np.array(parts)

        return self.film(columns, rows, given, cut)

    def starved_arc(self, columns, rows, start, end, inlet):
        """Arc from one angle to the other [rad] whose inlet is filled to the part `inlet`; the rest is open."""
        x = self.radius * np.linspace(start, end, columns + 1)
        z = self.length / 2 * np.arange(rows + 1) / rows
        given = np.full((columns + 1, rows + 1), np.nan)
        given[-1], given[:, -1] = 0.0, 0.0
        return Film(x, z, None, self.thickness, self.speed * self.radius, self.viscosity, given, None, inlet)
