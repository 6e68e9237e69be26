"""Quadratic triangles of a film.vtu in the developed plane, without VTK's own interpolation.

Nodes v0 v1 v2 m01 m12 m20, reference triangle (0,0), (1,0), (0,1).
"""

import numpy as np

EDGES = ((0, 1, 3), (1, 2, 4), (2, 0, 5))


def cells(grid):
    """(m, 6) nodes of each cell."""
    return grid.cells_dict[22]


def shape(xi, eta):
    """The six shape functions, (6, ...)."""
    zeta = 1 - xi - eta
    return np.array([
        zeta * (2 * zeta - 1), xi * (2 * xi - 1), eta * (2 * eta - 1),
        4 * zeta * xi, 4 * xi * eta, 4 * eta * zeta,
    ])  # fmt: skip


def shape_gradient(xi, eta):
    """Derivatives by xi and eta, (2, 6, ...)."""
    zeta, zero = 1 - xi - eta, np.zeros_like(xi)
    return np.array([
        [1 - 4 * zeta, 4 * xi - 1, zero, 4 * (zeta - xi), 4 * eta, -4 * eta],
        [1 - 4 * zeta, zero, 4 * eta - 1, -4 * xi, 4 * xi, 4 * (zeta - eta)],
    ])  # fmt: skip


def jacobian(nodes, xi, eta):
    """d(x, y)/d(xi, eta), (m, 2, 2), of cells with nodes (m, 6, 2) at one point each."""
    return np.einsum("rkm,mkc->mcr", shape_gradient(xi, eta), nodes)


def area(nodes):
    """Area [m2] of curved cells (m, 6, 2): det J is quadratic, the edge-midpoint rule is exact."""
    total = 0.0
    for xi, eta in ((0.5, 0.0), (0.5, 0.5), (0.0, 0.5)):
        ones = np.ones(len(nodes))
        total += np.linalg.det(jacobian(nodes, xi * ones, eta * ones)).sum() / 6
    return total


def corner_areas(nodes):
    """Area [m2] of the straight triangle through the three vertices, positive if anticlockwise."""
    first, second = nodes[:, 1] - nodes[:, 0], nodes[:, 2] - nodes[:, 0]
    return (first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]) / 2


def bulge(nodes):
    """Distance of each mid-side node from its edge's midpoint, by edge length, (m, 3)."""
    columns = []
    for a, b, middle in EDGES:
        gap = nodes[:, middle] - (nodes[:, a] + nodes[:, b]) / 2
        columns.append(np.linalg.norm(gap, axis=1) / np.linalg.norm(nodes[:, b] - nodes[:, a], axis=1))
    return np.column_stack(columns)


def locate(nodes, points):
    """(cell, xi, eta) of each point, by Newton's method in all cells whose box holds it."""
    low, high = nodes.min(axis=1) - 1e-9, nodes.max(axis=1) + 1e-9
    candidates = [np.flatnonzero(((low <= point) & (point <= high)).all(axis=1)) for point in points]
    cell, place = np.concatenate(candidates), np.repeat(points, list(map(len, candidates)), axis=0)
    local = np.full((len(cell), 2), 1 / 3)
    for _ in range(20):
        gap = np.einsum("km,mkc->mc", shape(local[:, 0], local[:, 1]), nodes[cell]) - place
        slope = jacobian(nodes[cell], local[:, 0], local[:, 1])
        local = local - np.linalg.solve(slope, gap[:, :, None])[:, :, 0]
    depth = np.minimum(local.min(axis=1), 1 - local.sum(axis=1))
    ends = np.cumsum(list(map(len, candidates)))
    best = [start + int(np.argmax(depth[start:end])) for start, end in zip([0, *ends[:-1]], ends)]
    assert depth[best].min() > -1e-9, f"no cell holds {place[best[int(np.argmin(depth[best]))]]}"
    return [(cell[k], *local[k]) for k in best]
