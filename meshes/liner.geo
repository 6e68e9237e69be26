// Developed surface of a journal-bearing liner: x = R phi, y = z, lengths in metres.
// Included by the other .geo files, which set what is particular to them first.
//   phi_from, phi_to  [deg]  extent of the film; full_ring = 1 makes the two edges one seam
//   hole              0 none, 1 cut out, 2 meshed as a region of its own
//   hole_angle        [deg]  centre of the hole, at z = 0
//   size, hole_size   [m]    cell size far from the hole, on its rim
//   order             2 (6-node triangles) or 1; gmsh's own `-order` has no effect here
//   peak, peak_angle, peak_width   the size shrinks by the part `peak` around this angle [deg]
SetFactory("Built-in");
DefineConstant[ full_ring = 0, hole = 0, hole_angle = 130, hole_size = 1e-3, growth = 0.2,
                peak = 0, peak_angle = 165, peak_width = 35, order = 2 ];

R = 0.0375;               // journal radius
B = 2 * R;                // full length
a = 0.017 / 2;            // radius of the feed hole
deg = Pi / 180;
x_from = R * phi_from * deg;
x_to = R * phi_to * deg;
x_hole = R * hole_angle * deg;

Point(1) = {x_from, -B/2, 0};
Point(2) = {x_to, -B/2, 0};
Point(3) = {x_to, B/2, 0};
Point(4) = {x_from, B/2, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {4, 3};
Line(4) = {1, 4};
Curve Loop(1) = {1, 2, -3, -4};

If (hole > 0)
  Point(5) = {x_hole, 0, 0};
  Point(6) = {x_hole + a, 0, 0};
  Point(7) = {x_hole, a, 0};
  Point(8) = {x_hole - a, 0, 0};
  Point(9) = {x_hole, -a, 0};
  Circle(5) = {6, 5, 7};
  Circle(6) = {7, 5, 8};
  Circle(7) = {8, 5, 9};
  Circle(8) = {9, 5, 6};
  Curve Loop(2) = {5, 6, 7, 8};
  Plane Surface(1) = {1, 2};
Else
  Plane Surface(1) = {1};
EndIf
Physical Surface("film") = {1};
Physical Curve("end_low") = {1};
Physical Curve("end_high") = {3};
If (full_ring)
  Periodic Curve {2} = {4} Translate {x_to - x_from, 0, 0};
  Physical Curve("seam_low") = {4};
  Physical Curve("seam_high") = {2};
Else
  Physical Curve("arc_from") = {4};
  Physical Curve("arc_to") = {2};
EndIf
If (hole == 1)
  Physical Curve("feed_hole") = {5, 6, 7, 8};
EndIf
If (hole == 2)
  Plane Surface(2) = {2};
  Physical Surface("feed_hole") = {2};
EndIf

// Cell size: finer around the pressure peak, and growing away from the rim of the hole.
Field[1] = MathEval;
Field[1].F = Sprintf("%g*(1-%g*exp(0-((x-%g)/%g)^2))", size, peak, R*peak_angle*deg, R*peak_width*deg);
Field[2] = MathEval;
Field[2].F = Sprintf("%g+%g*abs(sqrt((x-%g)^2+y^2)-%g)", hole_size, growth, x_hole, a);
Field[3] = Min;
If (hole > 0)
  Field[3].FieldsList = {1, 2};
Else
  Field[3].FieldsList = {1};
EndIf
Background Field = 3;

Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.Algorithm = 6;               // frontal Delaunay
Mesh.ElementOrder = order;        // 2: 6-node triangles, 1: straight ones
Mesh.HighOrderOptimize = 0;       // mid-side nodes of the rim stay on the circle
Mesh.MshFileVersion = 4.1;
