// Shell of 180 degrees with 592 cells and 1245 nodes, the counts printed in the study. A region
// with one hole cut out cannot have both counts (Euler), so the hole is meshed.
phi_from = 40;
phi_to = 220;
hole = 2;
size = 9.5e-3;
hole_size = 2.8e-3;
growth = 0.3;
peak = 0.4;
peak_width = 40;
Include "liner.geo";
Transfinite Curve {1, 3} = 22;    // 60 edges on the outer boundary: nodes = 2 cells + 60 + 1
Transfinite Curve {2, 4} = 10;
