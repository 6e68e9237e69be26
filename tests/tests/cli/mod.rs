//! The program as its user meets it: exit status, stdout, stderr, and the files it leaves.

mod characteristics;
mod complaints;
mod converge;
mod cost;
mod design;
mod drawing;
mod files;
mod first_minutes;
mod headlines;
mod heat;
mod load;
mod meshes;
mod oil;
mod shipped;
mod solve;
mod spread;
mod standard;
mod sweep;
mod theories;
mod verify;
