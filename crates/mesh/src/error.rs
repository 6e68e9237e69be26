//! The one error of this crate: reading and writing files, unrolling, putting rims on circles.

use std::fmt;
use std::path::PathBuf;

use crate::Defect;
use crate::defect::MOST_DEFECTS;

/// How many of many like complaints are printed.
const SHOWN: usize = 8;
/// Groups listed in a message at most.
const NAMES: usize = 20;

/// Why a mesh could not be had. Positions are `(x, z)` [m] on the developed surface unless said.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// Something is wrong in a named file.
    #[error("{}: {error}", path.display())]
    InFile {
        /// The file.
        path: PathBuf,
        /// What is wrong in it.
        error: Box<Error>,
    },
    /// The path names no plain file.
    #[error("the mesh {} is not a plain file; give the path of a .msh file", path.display())]
    NotPlain {
        /// The path.
        path: std::path::PathBuf,
    },
    /// The operating system refused.
    #[error("cannot {action} {}: {error}; check the path and its permissions", path.display())]
    Io {
        /// "read" or "write".
        action: &'static str,
        /// The file.
        path: PathBuf,
        /// The reason it gave.
        error: std::io::Error,
    },
    /// No `$MeshFormat` section.
    #[error(
        "this is not a gmsh mesh file: no line \"$MeshFormat\" before the mesh; write one with gmsh -2 -format msh41"
    )]
    NotMsh,
    /// A version other than 4.1.
    #[error(
        "the file has the gmsh format {version}, but 4.1 is needed; convert it: gmsh -save -format msh41 -o NEW.msh OLD.msh (in a .geo: Mesh.MshFileVersion = 4.1)"
    )]
    Version {
        /// Version as the file states it.
        version: String,
    },
    /// A binary layout that is not read.
    #[error(
        "the file has {what}; write it again with gmsh on a common (64-bit, little-endian) machine, or as text (Mesh.Binary = 0)"
    )]
    Encoding {
        /// What is uncommon.
        what: String,
    },
    /// A partitioned mesh.
    #[error("the mesh is partitioned ($PartitionedEntities); in gmsh undo that before saving (Mesh > Unpartition)")]
    Partitioned,
    /// The file breaks off or contradicts itself.
    #[error("${section}, {position}: {what}; the file is damaged or incomplete, write it again from gmsh")]
    Damaged {
        /// Section of the file, without the dollar sign.
        section: String,
        /// Position in the file.
        position: FilePosition,
        /// What was found.
        what: String,
    },
    /// A section that is needed is not there.
    #[error("the file has no section ${section}; {remedy}")]
    NoSection {
        /// Section, without the dollar sign.
        section: &'static str,
        /// What to do.
        remedy: &'static str,
    },
    /// Elements that the solver has no use for.
    #[error(
        "$Elements, {position}: the mesh holds {element} (gmsh type {kind}), but 3- or 6-node triangles are needed; {remedy}"
    )]
    Element {
        /// Name of the element.
        element: &'static str,
        /// The number that gmsh gives the type.
        kind: i32,
        /// Position in the file.
        position: FilePosition,
        /// What to do.
        remedy: &'static str,
    },
    /// 3-node and 6-node triangles in one file.
    #[error(
        "the mesh mixes {straight} 3-node and {curved} 6-node triangles; set one order for all (Mesh.ElementOrder)"
    )]
    MixedOrders {
        /// Number of 3-node triangles.
        straight: usize,
        /// Number of 6-node triangles.
        curved: usize,
    },
    /// Two nodes have one tag.
    #[error("two nodes have the tag {tag}; in gmsh renumber the nodes (Mesh > Renumber) and save again")]
    DuplicateTag {
        /// The tag.
        tag: u64,
    },
    /// An element stands on a node that is not there.
    #[error("element {element} stands on node {node}, which the file does not list; write it again from gmsh")]
    Dangling {
        /// Tag of the element.
        element: u64,
        /// Tag of the node.
        node: u64,
    },
    /// A block of elements lies on an entity that is not there.
    #[error(
        "elements lie on the {} {tag}, which $Entities does not list; write the file again from gmsh",
        if *dim == 1 { "curve" } else { "surface" }
    )]
    UnknownEntity {
        /// Dimension: 1 curve, 2 surface.
        dim: i32,
        /// Tag of the entity.
        tag: i32,
    },
    /// No element belongs to a physical group.
    #[error(
        "the file has no physical groups; in gmsh give the surface the physical name \"film\" and name the curves at the ends (Physical Curve(\"end_low\") = {{...}})"
    )]
    NoGroups,
    /// Groups that the scene needs are not in the file.
    #[error(
        "the mesh lacks {}{}; it has {}; {remedy}",
        missing.join(", "),
        meant(missing, present),
        if present.is_empty() { "no groups".to_owned() } else { some_of(present) }
    )]
    MissingGroups {
        /// Each group that is missing: kind and name.
        missing: Vec<String>,
        /// The groups that exist: kind and name.
        present: Vec<String>,
        /// What to do.
        remedy: &'static str,
    },
    /// The nodes lie neither in a plane nor on a cylinder.
    #[error(
        "the nodes lie neither in a plane z = constant (the unrolled liner) nor on a cylinder with its axis along x, y or z: node {node} is {distance:.3e} off the best one (axis {axis}, radius {radius:.6e}, file units); put all vertices on the liner"
    )]
    NotALiner {
        /// Tag of the node farthest off.
        node: u64,
        /// Distance of the node, in file units.
        distance: f64,
        /// Axis of the best cylinder.
        axis: char,
        /// Radius of the best cylinder, in file units.
        radius: f64,
    },
    /// A flat mesh in another plane than z = constant.
    #[error(
        "the mesh lies in the plane {axis} = constant; an unrolled liner has x = R phi along x and the axis along y: turn it into z = constant"
    )]
    WrongPlane {
        /// The direction normal to the mesh.
        axis: char,
    },
    /// A length of the file is not that of the scene.
    #[error(
        "{quantity} is {file:.9} {unit} in the mesh but {scene:.9} {unit} in the scene{hint}; correct the one that is wrong"
    )]
    Disagrees {
        /// What was measured.
        quantity: &'static str,
        /// Value in the mesh, in `unit`.
        file: f64,
        /// Value in the scene, in `unit`.
        scene: f64,
        /// Unit of both: "m" or "deg".
        unit: &'static str,
        /// What may have caused it; empty or ", ...".
        hint: String,
    },
    /// A mesh of an arc starts elsewhere.
    #[error(
        "the film of the mesh runs from {file:.9} to {file_end:.9} {unit}, the arc of the scene from {scene:.9} to {scene_end:.9} {unit}; shift the mesh by {shift:.9} {unit}, or correct bearing.arc"
    )]
    Shifted {
        /// Start in the mesh, in `unit`.
        file: f64,
        /// End in the mesh, in `unit`.
        file_end: f64,
        /// Start in the scene, in `unit`.
        scene: f64,
        /// End in the scene, in `unit`.
        scene_end: f64,
        /// Shift that mends it, in `unit`.
        shift: f64,
        /// Unit: "m" along x of an unrolled mesh, "deg" about the axis of a cylinder.
        unit: &'static str,
    },
    /// A group at an edge of the liner does not lie there.
    #[error(
        "group \"{group}\" should lie at {direction} = {expected:.9} m, but its node {node} lies at {direction} = {found:.9} m; name another curve so"
    )]
    Misplaced {
        /// Name of the group.
        group: &'static str,
        /// "x" or "z".
        direction: char,
        /// Coordinate at which the node should lie [m].
        expected: f64,
        /// Coordinate at which the node lies [m].
        found: f64,
        /// Tag of the node.
        node: u64,
    },
    /// The film of a ring does not close.
    #[error(
        "the scene's film is a full ring, but that of the mesh is open from {from:.3} to {to:.3} deg, with no group at its edges; give the arc in the scene ([bearing] arc), or close the mesh"
    )]
    OpenRing {
        /// Start of the opening [deg].
        from: f64,
        /// End of the opening [deg].
        to: f64,
    },
    /// The two sides of a seam do not fit.
    #[error(
        "the seams do not fit: {count} nodes have no partner; node {node} of \"{group}\" at ({x:.9}, {z:.9}) m has {nearest} across; mesh them alike (in a .geo: Periodic Curve {{high}} = {{low}} Translate {{2*Pi*R, 0, 0}})"
    )]
    Seam {
        /// Nodes without a partner.
        count: usize,
        /// Tag of the first.
        node: u64,
        /// Seam group of the node.
        group: &'static str,
        /// Developed position of the node [m].
        x: f64,
        /// Axial position of the node [m].
        z: f64,
        /// The nearest node of the other seam, in words.
        nearest: String,
    },
    /// A value of the liner or the unit that cannot be.
    #[error("{what} is {value}, which cannot be; give {needed}")]
    Impossible {
        /// Name of the value.
        what: &'static str,
        /// The value.
        value: f64,
        /// What is possible.
        needed: &'static str,
    },
    /// A region by that name does not exist.
    #[error("the mesh has no region \"{region}\" with a rim; it has {}", some_of(present))]
    NoRegion {
        /// The name asked for.
        region: String,
        /// The regions that exist.
        present: Vec<String>,
    },
    /// The rim of a region is not the circle of the scene.
    #[error(
        "the rim of \"{region}\" is not the circle of the scene (centre x = {:.9} m, z = {:.9} m, radius {:.9} m): a node is {distance:.3e} m off it; {found}; correct the hole in the scene, or leave it out to take the rim as meshed",
        centre[0], centre[1], radius
    )]
    OffCircle {
        /// Name of the region.
        region: String,
        /// Centre asked for [m].
        centre: [f64; 2],
        /// Radius asked for [m].
        radius: f64,
        /// Largest distance of a rim vertex from the circle [m].
        distance: f64,
        /// The circle through the nodes, in words.
        found: String,
    },
    /// The triangles do not make a mesh.
    #[error("{}", list(.0))]
    Defects(Vec<Defect>),
}

impl Error {
    /// The error with the name of the file that it arose from.
    pub fn in_file(self, path: &std::path::Path) -> Self {
        Self::InFile { path: path.to_owned(), error: Box::new(self) }
    }
}

impl From<Vec<Defect>> for Error {
    fn from(defects: Vec<Defect>) -> Self {
        Self::Defects(defects)
    }
}

/// A place in a mesh file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FilePosition {
    /// Line of a text file, from 1.
    Line(usize),
    /// Byte of a binary file, from 0.
    Byte(usize),
}

impl fmt::Display for FilePosition {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line(line) => write!(out, "line {line}"),
            Self::Byte(byte) => write!(out, "byte {byte}"),
        }
    }
}

/// The names with commas between them; of many the first ones and how many more there are.
pub fn some_of(names: &[String]) -> String {
    let told = names[..names.len().min(NAMES)].join(", ");
    match names.len().saturating_sub(NAMES) {
        0 => told,
        more => format!("{told} and {more} more"),
    }
}

/// The groups that look like missing ones, as a clause; each of kind and name.
fn meant(missing: &[String], present: &[String]) -> String {
    const LETTERS: usize = 2;
    let near = |name: &String| {
        let other = present.iter().min_by_key(|other| strsim::osa_distance(name, other))?;
        let is_near = strsim::osa_distance(name, other) <= LETTERS && !missing.contains(other);
        is_near.then(|| format!("is {other} meant as {name}?"))
    };
    let clauses: Vec<String> = missing.iter().filter_map(near).collect();
    match clauses.is_empty() {
        true => String::new(),
        false => format!(" ({})", clauses.join(" ")),
    }
}

fn list(defects: &[Defect]) -> String {
    let mut lines: Vec<String> = defects.iter().take(SHOWN).map(Defect::to_string).collect();
    if defects.len() > SHOWN {
        let at_least = if defects.len() < MOST_DEFECTS { "" } else { " at least" };
        lines.push(format!("and {} more{at_least}", defects.len() - SHOWN));
    }
    lines.join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn many_defects_are_cut_short() {
        let text = Error::Defects(vec![Defect::Empty; 20]).to_string();
        assert_eq!(text.lines().count(), SHOWN + 1);
        assert!(text.ends_with("and 12 more"));
    }
}
