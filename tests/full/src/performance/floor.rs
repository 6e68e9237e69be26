//! What a path must do at least: bytes that must be moved over the measured bandwidth, or operations over the measured
//! rate, whichever takes longer.
//!
//! | path | bytes | operations |
//! |---|---|---|
//! | read | the file once, the mesh once | |
//! | draw | the mesh once | |
//! | number | the triangles and edges once, the pattern once (4 an entry, 4 a row) | |
//! | order and analyse | the pattern once, order and its inverse (8 a row) | |
//! | assemble | the mesh, unknowns and residual (16 a row) and the matrix (8 an entry) once | 260 a triangle |
//! | factorise | matrix and pattern (12 an entry) and the factor (8 an entry) once | squares of the column counts |
//! | back-substitute | the factor twice (16 an entry), the vector twice (32 a row) | 4 an entry of the factor |
//! | measure | the mesh once, the unknown once | |
//! | file to load | read, number, assemble; the matrix read once more (12 an entry) | that of assembly |
//!
//! Of the 260 operations a triangle the film thickness takes 20 at each of 7 points, the element 120. The floor from
//! file to load is that of any solver.
//!
//! The mesh is 16 bytes a vertex, 12 a triangle, 16 an edge (ends and triangles). Indices have 4 bytes, numbers 8.
//! Iterative paths (cavity, equilibrium) have the floor of one film from file to load without its file.

use oilwedge_fem::{Analysis, Assembler};

use super::machine::Machine;

/// Operations of assembly a triangle.
const FLOPS_OF_ELEMENT: f64 = 7.0 * 20.0 + 120.0;

/// The sizes on which the work of the paths depends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sizes {
    /// Unknowns, rows of the matrix.
    pub rows: f64,
    /// Entries of the matrix.
    pub entries: f64,
    /// Vertices, edges and triangles of the mesh.
    pub mesh: [f64; 3],
    /// Bytes of the mesh file.
    pub file: f64,
    /// Entries of the Cholesky factor.
    pub factor: f64,
    /// Operations of the Cholesky factorisation.
    pub factor_flops: f64,
}

/// The paths that have a floor.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Path {
    /// Read the mesh from a file.
    Read,
    /// Draw the mesh.
    Draw,
    /// Number unknowns, make the pattern.
    Number,
    /// Order and analyse.
    Analyse,
    /// Assemble matrix and residual.
    Assemble,
    /// Factorise.
    Factorise,
    /// Back-substitution.
    Substitute,
    /// Quantities.
    Measure,
    /// One film from its mesh.
    Film,
    /// One film from its file.
    FileToLoad,
}

impl Sizes {
    /// The sizes of an assembled and analysed system whose mesh came from `file` bytes.
    pub fn of(assembler: &Assembler, analysis: &Analysis, file: u64) -> Self {
        let mesh = assembler.space().mesh();
        Self {
            rows: assembler.space().dofs() as f64,
            entries: assembler.pattern().columns.len() as f64,
            mesh: [mesh.points().len() as f64, mesh.topology().edges.len() as f64, mesh.triangles().len() as f64],
            file: file as f64,
            factor: analysis.factor_entries() as f64,
            factor_flops: analysis.factor_flops(),
        }
    }

    fn mesh_bytes(&self) -> f64 {
        let [vertices, edges, triangles] = self.mesh;
        16.0 * vertices + 16.0 * edges + 12.0 * triangles
    }

    /// Bytes that must be moved and operations that must be done.
    pub fn work(&self, path: Path) -> [f64; 2] {
        let [_, edges, triangles] = self.mesh;
        let both = |list: &[Path]| {
            list.iter().fold([0.0; 2], |[bytes, flops], &path| {
                let [more_bytes, more_flops] = self.work(path);
                [bytes + more_bytes, flops + more_flops]
            })
        };
        match path {
            Path::Read => [self.file + self.mesh_bytes(), 0.0],
            Path::Draw => [self.mesh_bytes(), 0.0],
            Path::Number => [16.0 * edges + 12.0 * triangles + 4.0 * (self.entries + self.rows), 0.0],
            Path::Analyse => [4.0 * (self.entries + self.rows) + 8.0 * self.rows, 0.0],
            Path::Assemble => [self.mesh_bytes() + 16.0 * self.rows + 8.0 * self.entries, FLOPS_OF_ELEMENT * triangles],
            Path::Factorise => [12.0 * self.entries + 8.0 * self.factor, self.factor_flops],
            Path::Substitute => [16.0 * self.factor + 32.0 * self.rows, 4.0 * self.factor],
            Path::Measure => [self.mesh_bytes() + 8.0 * self.rows, 0.0],
            Path::Film => {
                let [bytes, flops] = both(&[Path::Number, Path::Assemble]);
                [bytes + 12.0 * self.entries, flops]
            }
            Path::FileToLoad => both(&[Path::Read, Path::Film]),
        }
    }

    /// The least time of a path on so many threads [s].
    pub fn floor(&self, path: Path, machine: &Machine, threads: usize) -> f64 {
        let [bytes, flops] = self.work(path);
        let moved = bytes / machine.bandwidth_on(threads);
        moved.max(flops / (threads as f64 * machine.flops))
    }
}
