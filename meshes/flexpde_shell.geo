// Shell of 180 degrees, feed hole cut out.
phi_from = 40;
phi_to = 220;
hole = 1;
size = 3.3e-3;
hole_size = 1e-3;
peak = 0.4;
Include "liner.geo";
