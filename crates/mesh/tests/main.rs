//! Tests of meshes from files and of generated ones, as one program.

mod coarser_meshes;
mod damaged_files;
mod flipped_meshes;
mod generated_liners;
mod gmsh_files;
mod hostile_files;
mod random;
mod written_meshes;
