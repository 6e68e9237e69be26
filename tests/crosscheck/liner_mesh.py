"""Read a gmsh mesh of a liner and lay it out on the developed plane x = R phi, y = z [m].

Independent of the Rust reader: gmsh's own API reads the file. Cells always have six nodes,
v0 v1 v2 m01 m12 m20; straight meshes get their edge midpoints here.
"""

from dataclasses import dataclass

import gmsh
import numpy as np

EDGES = ((0, 1, 3), (1, 2, 4), (2, 0, 5))  # local nodes: start, end, middle


@dataclass
class LinerMesh:
    """Developed mesh.

    points   (n, 2)  developed coordinates [m]; a seam shows its nodes twice
    cells    (m, 6)  nodes of each cell
    unknown  (n,)    number of the unknown at each node; the two sides of a seam share theirs
    surfaces         group -> cell numbers
    curves           group -> (k, 3) edges, oriented with the cell on their left
    straight         True if every mid-side node is an edge midpoint
    """

    points: np.ndarray
    cells: np.ndarray
    unknown: np.ndarray
    surfaces: dict
    curves: dict
    straight: bool


@dataclass
class MeshFile:
    """Nodes and groups as the file has them; nodes are counted from 0."""

    points: np.ndarray
    cells: np.ndarray
    surfaces: dict
    edges: dict


def read_file(path):
    """Nodes (n, 3), triangles (m, 3 or 6) and physical groups of a .msh file."""
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.open(str(path))
    tags, coordinates, _ = gmsh.model.mesh.getNodes()
    index = np.zeros(int(tags.max()) + 1, dtype=int)
    index[tags] = np.arange(len(tags))
    cells, surfaces, edges = [], {}, {}
    for dim, group in gmsh.model.getPhysicalGroups():
        name = gmsh.model.getPhysicalName(dim, group)
        blocks = [_elements(dim, e, index) for e in gmsh.model.getEntitiesForPhysicalGroup(dim, group)]
        block = np.vstack(blocks)
        if dim == 1:
            edges[name] = block
        else:
            first = sum(len(c) for c in cells)
            surfaces[name] = np.arange(first, first + len(block))
            cells.append(block)
    gmsh.finalize()
    return MeshFile(coordinates.reshape(-1, 3), np.vstack(cells), surfaces, edges)


def _elements(dim, entity, index):
    kinds, _, nodes = gmsh.model.mesh.getElements(dim, entity)
    width = {1: 2, 2: 3, 8: 3, 9: 6}[int(kinds[0])]
    return index[nodes[0]].reshape(-1, width)


def read_liner(path, radius, holes=()):
    """Developed mesh of a file; `holes` are (group, centre x [m], z [m], radius [m]) with exact rims."""
    file = read_file(path)
    straight = file.cells.shape[1] == 3
    numbers = _with_midpoint_numbers(file.cells) if straight else file.cells
    corners = _developed_coordinates(file, radius)
    if straight:
        middles = [(corners[:, a] + corners[:, b]) / 2 for a, b, _ in EDGES]
        corners = np.concatenate([corners, np.stack(middles, axis=1)], axis=1)
    points, cells, origin = _separate_nodes(numbers, corners)
    curves = {name: _oriented_edges(cells, origin, pairs) for name, pairs in file.edges.items()}
    unknown = _glue_seam(points, origin, curves)
    mesh = LinerMesh(points, cells, unknown, file.surfaces, curves, straight)
    for group, x, z, hole_radius in holes:
        _project_rim(mesh, _rim_nodes(mesh, group), (x, z), hole_radius, 2 * np.pi * radius)
        mesh.straight = False
    return mesh


def refined(mesh, radius, holes=()):
    """Every cell divided into four along its quadratic map; rims of `holes` stay on their circles.

    Each new node halves the way between a vertex and the middle of an edge, or between two middles, of one cell: a pair
    of old nodes names it, and a pair of old unknowns its unknown."""
    corner = np.array([[0, 0], [1, 0], [0, 1], [0.5, 0], [0.5, 0.5], [0, 0.5]])
    pairs = [(0, 3), (3, 1), (1, 4), (4, 2), (2, 5), (5, 0), (3, 4), (4, 5), (5, 3)]
    number = {pair: 6 + k for k, pair in enumerate(pairs)} | {pair[::-1]: 6 + k for k, pair in enumerate(pairs)}
    keys = np.sort(np.stack([mesh.cells[:, list(pair)] for pair in pairs], axis=1), axis=2).reshape(-1, 2)
    keys, first, new = np.unique(keys, axis=0, return_index=True, return_inverse=True)
    xi, eta = np.array([(corner[a] + corner[b]) / 2 for a, b in pairs]).T
    zeta = 1 - xi - eta
    vertices = [zeta * (2 * zeta - 1), xi * (2 * xi - 1), eta * (2 * eta - 1)]
    quadratic = np.array([*vertices, 4 * zeta * xi, 4 * xi * eta, 4 * eta * zeta])
    places = np.einsum("kp,mkc->mpc", quadratic, mesh.points[mesh.cells]).reshape(-1, 2)[first]
    count = len(mesh.points)
    wide = np.hstack([mesh.cells, count + new.reshape(-1, len(pairs))])
    children = [(0, 3, 5), (3, 1, 4), (5, 4, 2), (3, 4, 5)]
    local = [[a, b, c, number[a, b], number[b, c], number[c, a]] for a, b, c in children]
    cells = wide[:, local].reshape(-1, 6)
    surfaces = {name: (4 * k[:, None] + np.arange(4)).ravel() for name, k in mesh.surfaces.items()}
    place = {tuple(key): count + k for k, key in enumerate(keys.tolist())}
    curves = {
        name: np.array([
            [a, b, place[min(a, b), max(a, b)]] for s, e, m in edges.tolist() for a, b in ((s, m), (m, e))
        ])
        for name, edges in mesh.curves.items()
    }  # fmt: skip
    unknowns = np.sort(mesh.unknown[keys], axis=1)
    _, unknown = np.unique(unknowns, axis=0, return_inverse=True)
    unknown = np.concatenate([mesh.unknown, mesh.unknown.max() + 1 + unknown.ravel()])
    points = np.vstack([mesh.points, places])
    fine = LinerMesh(points, cells, unknown, surfaces, curves, mesh.straight)
    for group, x, z, hole_radius in holes:
        _project_rim(fine, _rim_nodes(fine, group), (x, z), hole_radius, 2 * np.pi * radius)
    return fine


def _with_midpoint_numbers(triangles):
    """Six node numbers a cell: one new number for each edge of a 3-node mesh."""
    pairs = np.sort(np.stack([triangles[:, [a, b]] for a, b, _ in EDGES], axis=1), axis=2)
    _, edge = np.unique(pairs.reshape(-1, 2), axis=0, return_inverse=True)
    return np.hstack([triangles, triangles.max() + 1 + edge.reshape(-1, 3)])


def _developed_coordinates(file, radius):
    """(m, 3 or 6, 2): coordinates of each cell's nodes, continuous inside the cell."""
    if np.ptp(file.points[:, 2]) == 0.0:
        return file.points[file.cells, :2]
    x, y, z = file.points.T
    assert np.allclose(np.hypot(x, y), radius, rtol=1e-9), "the axis of the cylinder must be z"
    phi = np.arctan2(y, x)[file.cells]
    phi = np.where(phi < 0, phi + 2 * np.pi, phi)
    crossing = np.ptp(phi, axis=1, keepdims=True) > np.pi
    phi = np.where(crossing & (phi < np.pi), phi + 2 * np.pi, phi)
    z = z - (z.min() + z.max()) / 2
    return np.stack([radius * phi, z[file.cells]], axis=2)


def _separate_nodes(numbers, coordinates):
    """A node for each (number, x): a node that is met on both sides of the cut becomes two."""
    keys = np.column_stack([numbers.ravel(), coordinates[:, :, 0].ravel()])
    keys, first, cells = np.unique(keys, axis=0, return_index=True, return_inverse=True)
    return coordinates.reshape(-1, 2)[first], cells.reshape(numbers.shape), keys[:, 0].astype(int)


def _oriented_edges(cells, origin, edges):
    """The edges of a group as their cells run through them."""
    count = origin.max() + 1

    def keys(pairs):
        return np.sort(pairs, axis=1) @ [count, 1]

    all_edges = np.concatenate([cells[:, local] for local in EDGES])
    return all_edges[np.isin(keys(origin[all_edges[:, :2]]), keys(edges[:, :2]))]


def _glue_seam(points, origin, curves):
    """Unknown of each node: one for each node of the file, and one for each pair across the seam."""
    _, unknown = np.unique(origin, return_inverse=True)
    if "seam_low" in curves:
        low, high = (np.unique(curves[name]) for name in ("seam_low", "seam_high"))
        low, high = low[np.argsort(points[low, 1])], high[np.argsort(points[high, 1])]
        assert np.allclose(points[low, 1], points[high, 1], rtol=0, atol=1e-9)
        unknown[high] = unknown[low]
        _, unknown = np.unique(unknown, return_inverse=True)
    return unknown


def _rim_nodes(mesh, group):
    """Nodes on the rim of a feed that is cut out (a curve) or meshed (a surface)."""
    if group in mesh.curves:
        return np.unique(mesh.curves[group])
    inside, outside = (np.unique(mesh.cells[mesh.surfaces[name]]) for name in (group, "film"))
    return np.intersect1d(inside, outside)


def _project_rim(mesh, nodes, centre, hole_radius, circumference):
    """Move rim nodes onto the circle, along its radius, at the nearest image of the centre."""
    offset = mesh.points[nodes] - centre
    turns = np.column_stack([np.round(offset[:, 0] / circumference), np.zeros(len(nodes))])
    offset -= turns * circumference
    on_circle = hole_radius * offset / np.linalg.norm(offset, axis=1, keepdims=True)
    mesh.points[nodes] = centre + turns * circumference + on_circle
