//! Bytes as a mesh file: what `oilwedge check FILE.msh` does with them, and what a scene does with the mesh then.

#![no_main]

use std::alloc::System;
use std::f64::consts::TAU;

use cap::Cap;
use libfuzzer_sys::{fuzz_mutator, fuzz_target, fuzzer_mutate};
use oilwedge_fuzz::{bounded, mutate_words};
use oilwedge_mesh::{LinerDomain, Mesh, Quality, coarsen, developed, flip, gmsh};

#[global_allocator]
static ALLOCATOR: Cap<System> = Cap::new(System, usize::MAX);

/// Bytes that reading and checking may take for each byte of a file.
const BYTES_PER_BYTE: usize = 64;
/// Meshes of more triangles are not worked upon.
const MOST: usize = 1000;

fuzz_target!(|bytes: &[u8]| {
    bounded(&ALLOCATOR, BYTES_PER_BYTE * bytes.len(), || match gmsh::parse(bytes) {
        Ok(file) => check(&file),
        Err(error) => assert!(error.to_string().len() < 10_000),
    });
});

fn check(file: &gmsh::MshFile) {
    match developed::alone(file) {
        Ok(mesh) => work_upon(&mesh),
        Err(error) => assert!(error.to_string().len() < 10_000),
    }
    // The liners of the seeds.
    for arc in [None, Some((0.0, 0.5 * TAU))] {
        let liner = LinerDomain {
            radius: 1.0,
            length: 2.0,
            arc,
        };
        let Ok(Ok(mesh)) = developed::unroll(file, &liner, 1.0).map(Mesh::build) else {
            continue;
        };
        if mesh.triangles().len() <= MOST {
            let _ = coarsen::coarser(&mesh, &liner, None, 2.0);
        }
    }
}

fn work_upon(mesh: &Mesh) {
    let quality = Quality::of(mesh);
    assert!(quality.least_angle.is_finite() && quality.area.is_finite());
    if mesh.triangles().len() > MOST {
        return;
    }
    let text = gmsh::to_text(mesh);
    gmsh::parse(text.as_bytes()).expect("what was written is read");
    let _ = flip::to_delaunay(mesh, &[]);
}

fuzz_mutator!(|data: &mut [u8], size: usize, max_size: usize, seed: u32| {
    match seed.is_multiple_of(2) {
        true => mutate_words(data, size, max_size, seed / 2),
        false => None,
    }
    .unwrap_or_else(|| fuzzer_mutate(data, size, max_size))
});
