//! Triangle meshes of bearing liners: geometry and topology, no equation.
//!
//! A liner is meshed on its **developed surface**: the cylinder unrolled to the plane, with
//! `x = R phi` [m] along the circumference and `y = z` [m] along the axis. A closed ring keeps
//! `x` modulo its circumference (the *period*), so that its seam is not special: a triangle that
//! crosses it is laid out next to itself when its corners are asked for.
//!
//! Reading order: [`raw`] (triangles as a file lists them) becomes a [`Mesh`], numbered along a space-filling curve
//! ([`numbering`]), with its edges ([`topology`]) and named sets of edges and cells ([`region`]). [`gmsh`] reads and
//! writes files, [`developed`] unrolls them and glues the seam, [`rim`] puts the edges of round holes on their
//! [`circle`], [`refine`] divides triangles and keeps the geometry, [`coarsen`] meshes the plain liner anew with longer
//! edges, [`flip`] makes a mesh Delaunay, [`quality`] measures, [`locate`] finds points. What can go wrong is an
//! [`error`]; what can be wrong with triangles, a [`defect`].
//!
//! ```no_run
//! use oilwedge_mesh::{Circle, LinerDomain, Quality, developed, rim};
//!
//! let liner = LinerDomain { radius: 0.0375, length: 0.075, arc: None };
//! let metre = 1.0;
//! let mesh = developed::read("liner.msh", &liner, metre)?;
//! let hole = Circle { centre: [0.0851, 0.0], radius: 0.0085 };
//! let mesh = rim::curve_rim(&mesh, "feed_hole", &hole)?;
//! println!("least angle {:.1} degrees", Quality::of(&mesh).least_angle);
//! # Ok::<(), oilwedge_mesh::Error>(())
//! ```

mod build;
pub mod circle;
pub mod coarsen;
pub mod defect;
pub mod developed;
pub mod error;
pub mod flip;
pub mod generate;
pub mod gmsh;
pub mod locate;
pub mod mesh;
pub mod numbering;
pub mod quality;
pub mod raw;
pub mod refine;
pub mod region;
pub mod rim;
mod size_tree;
pub mod topology;

pub use circle::Circle;
pub use coarsen::Coarser;
pub use defect::Defect;
pub use developed::LinerDomain;
pub use error::Error;
pub use flip::Flipped;
pub use locate::Locator;
pub use mesh::Mesh;
pub use quality::Quality;
pub use raw::{RawMesh, triangle_area};
pub use refine::Refined;
pub use region::Region;
pub use topology::Topology;
