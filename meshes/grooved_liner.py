"""Mesh a closed liner on the cylinder itself: one axial groove and two feed holes, no seam.

    python grooved_liner.py OUT.msh [ORDER]

The developed surface (x = R phi, y = z) is meshed in the plane with a periodic seam, the nodes are
mapped to (R cos phi, R sin phi, z) and the two sides of the seam become one line of nodes.
Lengths in metres, angles in degrees. ORDER 2 (default) gives 6-node triangles, ORDER 1 straight ones.
"""

import sys

import gmsh
import numpy as np

RADIUS = 0.0375
LENGTH = 0.075
GROOVE = {"angle": 300.0, "width": 20.0, "length": 0.75 * LENGTH}
HOLES = {  # diameter [m], angle [deg], z [m]
    "hole_a": (0.010, 30.0, 0.015),
    "hole_b": (0.008, 240.0, -0.012),
}
SIZE, RIM_SIZE, GROWTH = 4.5e-3, 1.2e-3, 0.25


def arc_length(angle):
    """R phi [m] of an angle [deg]."""
    return RADIUS * np.radians(angle)


def closed_loop(curves):
    return gmsh.model.geo.addCurveLoop(curves)


def polygon(corners):
    """Closed chain of straight lines through the corners."""
    points = [gmsh.model.geo.addPoint(x, y, 0.0) for x, y in corners]
    return [gmsh.model.geo.addLine(p, q) for p, q in zip(points, points[1:] + points[:1])]


def rectangle(x_low, x_high, y_low, y_high):
    return polygon([(x_low, y_low), (x_high, y_low), (x_high, y_high), (x_low, y_high)])


def circle(diameter, angle, z):
    """Four quarter arcs in the developed plane."""
    centre, a = arc_length(angle), diameter / 2
    middle = gmsh.model.geo.addPoint(centre, z, 0.0)
    rim = [
        gmsh.model.geo.addPoint(centre + a * dx, z + a * dy, 0.0)
        for dx, dy in ((1, 0), (0, 1), (-1, 0), (0, -1))
    ]
    return [gmsh.model.geo.addCircleArc(p, middle, q) for p, q in zip(rim, rim[1:] + rim[:1])]


def size_field(rims):
    """Cells grow away from the rims of the feeds."""
    field = gmsh.model.mesh.field
    distance = field.add("Distance")
    field.setNumbers(distance, "CurvesList", rims)
    field.setNumber(distance, "Sampling", 200)
    size = field.add("Threshold")
    field.setNumber(size, "InField", distance)
    field.setNumber(size, "SizeMin", RIM_SIZE)
    field.setNumber(size, "SizeMax", SIZE)
    field.setNumber(size, "DistMin", 0.0)
    field.setNumber(size, "DistMax", (SIZE - RIM_SIZE) / GROWTH)
    field.setAsBackgroundMesh(size)
    for name in ("MeshSizeExtendFromBoundary", "MeshSizeFromPoints"):
        gmsh.option.setNumber("Mesh." + name, 0)


def mesh_plane(order):
    """Mesh the developed plane; returns the film's surface and the curves of each group."""
    circumference = 2 * np.pi * RADIUS
    low, right, high, left = rectangle(0.0, circumference, -LENGTH / 2, LENGTH / 2)
    half = GROOVE["width"] / 2
    curves = {
        "groove": rectangle(
            arc_length(GROOVE["angle"] - half), arc_length(GROOVE["angle"] + half),
            -GROOVE["length"] / 2, GROOVE["length"] / 2,
        )
    }
    curves |= {name: circle(*hole) for name, hole in HOLES.items()}
    outer = closed_loop([low, right, high, left])
    surface = gmsh.model.geo.addPlaneSurface([outer] + [closed_loop(c) for c in curves.values()])
    gmsh.model.geo.synchronize()
    shift = np.eye(4)
    shift[0, 3] = circumference
    gmsh.model.mesh.setPeriodic(1, [right], [left], shift.ravel())
    size_field(sum(curves.values(), []))
    gmsh.option.setNumber("Mesh.Algorithm", 6)
    gmsh.option.setNumber("Mesh.HighOrderOptimize", 0)
    gmsh.model.mesh.generate(2)
    gmsh.model.mesh.setOrder(order)
    return surface, curves | {"end_low": [low], "end_high": [high]}


def elements(dim, entity):
    """(gmsh element type, node tags with one row an element) of one entity."""
    kinds, _, nodes = gmsh.model.mesh.getElements(dim, entity)
    width = gmsh.model.mesh.getElementProperties(kinds[0])[3]
    return kinds[0], nodes[0].reshape(-1, width)


def glue_seam(tags, points):
    """New number (from 1) of each node tag, with the nodes at x = 2 pi R taken for those at x = 0."""
    tolerance = 1e-9 * RADIUS
    on_left = np.flatnonzero(points[:, 0] < tolerance)
    on_right = np.flatnonzero(points[:, 0] > 2 * np.pi * RADIUS - tolerance)
    left = on_left[np.argsort(points[on_left, 1])]
    right = on_right[np.argsort(points[on_right, 1])]
    assert np.allclose(points[left, 1], points[right, 1], rtol=0, atol=tolerance)
    kept = np.ones(len(tags), dtype=bool)
    kept[right] = False
    number = np.cumsum(kept)
    number[right] = number[left]
    renumber = np.zeros(tags.max() + 1, dtype=np.uint64)
    renumber[tags] = number
    return renumber, points[kept]


def write_cylinder(path, renumber, plane_points, blocks):
    """Write the groups `blocks` (name -> dim, element type, node tags) on the cylinder."""
    gmsh.model.add("cylinder")
    phi, z = plane_points[:, 0] / RADIUS, plane_points[:, 1]
    points = np.column_stack([RADIUS * np.cos(phi), RADIUS * np.sin(phi), z])
    surface = gmsh.model.addDiscreteEntity(2)
    gmsh.model.mesh.addNodes(2, surface, np.arange(1, len(points) + 1), points.ravel())
    for name, (dim, kind, nodes) in blocks.items():
        entity = surface if dim == 2 else gmsh.model.addDiscreteEntity(1)
        gmsh.model.mesh.addElementsByType(entity, kind, [], renumber[nodes].ravel())
        gmsh.model.addPhysicalGroup(dim, [entity], name=name)
    gmsh.option.setNumber("Mesh.MshFileVersion", 4.1)
    gmsh.write(path)


def main(path, order):
    gmsh.initialize()
    gmsh.option.setNumber("General.Verbosity", 2)
    surface, curves = mesh_plane(order)
    blocks = {"film": (2, *elements(2, surface))}
    for name, members in curves.items():
        parts = [elements(1, curve) for curve in members]
        blocks[name] = (1, parts[0][0], np.vstack([nodes for _, nodes in parts]))
    tags = np.unique(blocks["film"][2])
    points = np.array([gmsh.model.mesh.getNode(tag)[0][:2] for tag in tags])
    renumber, kept = glue_seam(tags, points)
    write_cylinder(path, renumber, kept, blocks)
    gmsh.finalize()


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 2)
