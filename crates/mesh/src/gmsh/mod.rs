//! Mesh files of gmsh 4.1, text and binary: 3- or 6-node triangles, lines, physical groups.
//!
//! [`read`] takes the numbers out of the sections (`scan`), and makes nodes, triangles and named groups of them
//! (`assemble`). Nothing about bearings is known here: [`crate::developed`] makes a liner of it. [`write()`] is the way
//! back.

mod assemble;
mod cursor;
mod scan;
mod write;

use std::io::Read;
use std::path::Path;

pub use write::{to_text, write};

use crate::Error;

/// Bytes within which the first section must open.
const OPENING: u64 = 1 << 16;

/// The triangles of a gmsh file, as listed there: nodes in space, no check but that all is there.
///
/// Nodes are named by their index here; lengths are in the unit of the file.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct MshFile {
    /// All nodes `(x, y, z)`, mid-side nodes too. Finite.
    pub nodes: Vec<[f64; 3]>,
    /// Tag that gmsh gives each node.
    pub tags: Vec<u64>,
    /// Three vertices a triangle, at least one triangle.
    pub triangles: Vec<[u32; 3]>,
    /// Mid-side nodes of edges 01, 12, 20 of each triangle, if the file has 6-node triangles.
    pub mid_nodes: Option<Vec<[u32; 3]>>,
    /// Physical surfaces that hold triangles: name and triangles. One without a name is called "surface TAG".
    pub surfaces: Vec<(String, Vec<u32>)>,
    /// Physical curves that hold lines: name and the two ends of each. One without a name is called "curve TAG".
    pub curves: Vec<(String, Vec<[u32; 2]>)>,
    /// Pairs of nodes that correspond under a periodicity of gmsh.
    pub periodic: Vec<[u32; 2]>,
}

impl MshFile {
    /// Kind and name of every group, for messages.
    pub fn groups(&self) -> Vec<String> {
        let surfaces = self.surfaces.iter().map(|(name, _)| format!("surface \"{name}\""));
        let curves = self.curves.iter().map(|(name, _)| format!("curve \"{name}\""));
        surfaces.chain(curves).collect()
    }

    /// The physical surface of that name.
    pub fn surface(&self, name: &str) -> Option<&[u32]> {
        let found = self.surfaces.iter().find(|(group, _)| group == name);
        found.map(|(_, triangles)| triangles.as_slice())
    }

    /// The physical curve of that name.
    pub fn curve(&self, name: &str) -> Option<&[[u32; 2]]> {
        let found = self.curves.iter().find(|(group, _)| group == name);
        found.map(|(_, edges)| edges.as_slice())
    }
}

/// Reads a gmsh 4.1 file.
///
/// # Errors
/// As [`read_bytes`] and [`parse`], with the path.
pub fn read(path: impl AsRef<Path>) -> Result<MshFile, Error> {
    let path = path.as_ref();
    parse(&read_bytes(path)?).map_err(|error| error.in_file(path))
}

/// The content of a plain file.
///
/// # Errors
/// The operating system's message; a directory, device or pipe is refused, and a file in whose first 64 kB no section
/// opens: of a large one that is no mesh the rest is not read.
pub fn read_bytes(path: &Path) -> Result<Vec<u8>, Error> {
    let failed = |error| Error::Io { action: "read", path: path.to_owned(), error };
    let metadata = std::fs::metadata(path).map_err(failed)?;
    if !metadata.is_file() {
        return Err(Error::NotPlain { path: path.to_owned() });
    }
    let mut file = std::fs::File::open(path).map_err(failed)?;
    let mut bytes = Vec::new();
    (&mut file).take(OPENING).read_to_end(&mut bytes).map_err(failed)?;
    let opens = bytes.split(|&byte| byte == b'\n').any(|line| line.starts_with(b"$"));
    let is_of_two_bytes = scan::UTF_16.iter().any(|mark| bytes.starts_with(mark));
    if !opens && !is_of_two_bytes {
        return Err(Error::NotMsh.in_file(path));
    }
    let rest = usize::try_from(metadata.len().saturating_sub(OPENING)).unwrap_or(usize::MAX);
    bytes.try_reserve_exact(rest).map_err(|error| failed(error.into()))?;
    file.read_to_end(&mut bytes).map_err(failed)?;
    Ok(bytes)
}

/// Reads the content of a gmsh 4.1 file.
///
/// # Errors
/// The file has another format or version, is damaged, holds elements other than 3- or 6-node
/// triangles, lines and points, or has no physical groups.
pub fn parse(bytes: &[u8]) -> Result<MshFile, Error> {
    let scan = scan::scan(bytes)?;
    for (section, present, remedy) in [
        ("Entities", scan.entities.is_some(), "save with physical groups from a gmsh of version 4 or later"),
        ("Nodes", scan.nodes.is_some(), "mesh before saving (gmsh -2)"),
        ("Elements", scan.elements.is_some(), "mesh before saving (gmsh -2)"),
    ] {
        if !present {
            return Err(Error::NoSection { section, remedy });
        }
    }
    assemble::assemble(scan)
}
