// Shell of 180 degrees, feed hole meshed as a region of its own.
phi_from = 40;
phi_to = 220;
hole = 2;
size = 3.3e-3;
hole_size = 1e-3;
peak = 0.4;
Include "liner.geo";
