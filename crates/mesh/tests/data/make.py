"""Makes the .msh files beside this script, all of a liner of radius 1 and length 2 (python make.py, gmsh 4.15).

plane_ring*.msh   unrolled, x from 0.5 to 0.5 + 2 pi, one round hole of radius 0.4 at x = 3, y = 0.2
                  (_binary; _shuffled and _sparse: the same mesh with other node tags; _straight: 3 nodes)
cylinder_AXIS.msh closed, on the cylinder, its middle at (5, -3, 7)
half_x.msh        the half from 30 to 210 degrees of a cylinder along x
old_*.msh, parametric.msh, quads.msh, cubic.msh, volume.msh, partitioned.msh   to be refused
"""

import math
from pathlib import Path

import gmsh

HERE = Path(__file__).parent


def option(name, value):
    gmsh.option.setNumber("Mesh." + name, value)


def start(size, order=2):
    gmsh.clear()
    for name, value in {
        "ElementOrder": order, "MeshSizeMin": size, "MeshSizeMax": size, "MeshSizeFromPoints": 0,
        "MeshSizeExtendFromBoundary": 0, "MshFileVersion": 4.1, "Binary": 0, "SaveParametric": 0,
        "HighOrderOptimize": 0, "RecombineAll": 0,
    }.items():
        option(name, value)


def save(name):
    gmsh.write(str(HERE / name))


def group(dim, name, members):
    gmsh.model.addPhysicalGroup(dim, members, name=name)


def plane_ring(order=2):
    start(0.7, order)
    geo = gmsh.model.geo
    corners = [(0.5, -1), (0.5 + 2 * math.pi, -1), (0.5 + 2 * math.pi, 1), (0.5, 1)]
    p = [geo.addPoint(x, y, 0) for x, y in corners]
    low, right, high, left = (geo.addLine(p[a], p[b]) for a, b in ((0, 1), (1, 2), (3, 2), (0, 3)))
    middle = geo.addPoint(3, 0.2, 0)
    q = [geo.addPoint(3 + 0.4 * dx, 0.2 + 0.4 * dy, 0) for dx, dy in ((1, 0), (0, 1), (-1, 0), (0, -1))]
    rim = [geo.addCircleArc(q[k], middle, q[(k + 1) % 4]) for k in range(4)]
    surface = geo.addPlaneSurface([geo.addCurveLoop([low, right, -high, -left]), geo.addCurveLoop(rim)])
    geo.synchronize()
    shift = [1, 0, 0, 2 * math.pi, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
    gmsh.model.mesh.setPeriodic(1, [right], [left], shift)
    group(2, "film", [surface])
    for name, members in {"end_low": [low], "end_high": [high], "seam_low": [left], "seam_high": [right], "oil hole": rim}.items():
        group(1, name, members)
    gmsh.model.mesh.generate(2)


def cylinder(axis, angle=None, turn=0.0):
    start(0.9)
    occ = gmsh.model.occ
    direction = {"x": (2, 0, 0), "y": (0, 2, 0), "z": (0, 0, 2)}[axis]
    base = [c - d / 2 for c, d in zip((5, -3, 7), direction)]
    first = "xyz"[("xyz".index(axis) + 1) % 3]
    solid = occ.addCylinder(*base, *direction, 1, angle=angle or 2 * math.pi)
    occ.synchronize()
    # Where OpenCASCADE starts the angle is its own affair: turn the middle of the arc to where it belongs.
    mantle = max(gmsh.model.getEntities(2), key=lambda s: occ.getMass(*s))
    if angle:
        k = "xyz".index(axis)
        centre = occ.getCenterOfMass(*mantle)
        u, v = (centre[i % 3] - (5, -3, 7)[i % 3] for i in (k + 1, k + 2))
        occ.rotate([(3, solid)], 5, -3, 7, *direction, turn + angle / 2 - math.atan2(v, u))
        occ.synchronize()
    ends, edges = {}, []
    for _, curve in gmsh.model.getBoundary([mantle], oriented=False):
        x = occ.getCenterOfMass(1, curve)
        along = x["xyz".index(axis)] - (5, -3, 7)["xyz".index(axis)]
        if abs(abs(along) - 1) < 1e-6:
            ends["end_low" if along < 0 else "end_high"] = curve
        else:
            edges.append((curve, x))
    group(2, "film", [mantle[1]])
    for name, curve in ends.items():
        group(1, name, [curve])
    if angle:
        k = "xyz".index(axis)
        def phi(x):
            return math.atan2(x[(k + 2) % 3] - (5, -3, 7)[(k + 2) % 3], x[(k + 1) % 3] - (5, -3, 7)[(k + 1) % 3])
        edges.sort(key=lambda e: abs(phi(e[1]) - turn))
        group(1, "arc_from", [edges[0][0]])
        group(1, "arc_to", [edges[-1][0]])
    gmsh.model.mesh.generate(2)


def square(order=1):
    start(0.9, order)
    gmsh.model.occ.addRectangle(0, 0, 0, 1, 1)
    gmsh.model.occ.synchronize()
    group(2, "film", [1])


gmsh.initialize()
gmsh.option.setNumber("General.Verbosity", 2)

plane_ring()
save("plane_ring.msh")
option("Binary", 1)
save("plane_ring_binary.msh")
tags = [int(t) for t in gmsh.model.mesh.getNodes()[0]]
option("Binary", 0)
gmsh.model.mesh.renumberNodes(tags, [1 + (7 * t) % len(tags) for t in tags])  # a permutation if 7 does not divide
assert len(tags) % 7
save("plane_ring_shuffled.msh")
tags = [int(t) for t in gmsh.model.mesh.getNodes()[0]]
gmsh.model.mesh.renumberNodes(tags, [100000 + 3 * t for t in tags])
option("Binary", 1)
save("plane_ring_sparse.msh")
plane_ring(1)
option("Binary", 1)
save("plane_ring_straight.msh")

for axis in "xyz":
    cylinder(axis)
    save(f"cylinder_{axis}.msh")
cylinder("x", math.pi, math.radians(30))
save("half_x.msh")

square()
gmsh.model.mesh.generate(2)
for version in (1, 2.2, 4.0):
    option("MshFileVersion", version)
    save(f"old_{version:g}.msh")
option("MshFileVersion", 4.1)
option("SaveParametric", 1)
save("parametric.msh")
option("SaveParametric", 0)
gmsh.model.mesh.partition(2)
save("partitioned.msh")
square(3)
gmsh.model.mesh.generate(2)
save("cubic.msh")
square()
gmsh.model.mesh.generate(2)
gmsh.model.mesh.recombine()
save("quads.msh")
start(0.9, 1)
gmsh.model.occ.addBox(0, 0, 0, 1, 1, 1)
gmsh.model.occ.synchronize()
group(3, "film", [1])
gmsh.model.mesh.generate(3)
save("volume.msh")
gmsh.finalize()
