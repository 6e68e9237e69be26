// Plain ring, no hole, length / diameter = 1.
phi_from = 0;
phi_to = 360;
full_ring = 1;
size = 6.3e-3;
Include "liner.geo";
