// Full ring, feed hole cut out on the loaded side.
phi_from = 0;
phi_to = 360;
full_ring = 1;
hole = 1;
hole_angle = 130;
size = 4.2e-3;
hole_size = 1.1e-3;
peak = 0.4;
peak_angle = 180;
peak_width = 50;
Include "liner.geo";
