//! Where pressure is given: ends, edges of an arc, the film start, feeds.
//!
//! A region is a set of edges (a line, or the rim of a cut-out) and of cells (a meshed hole or
//! groove). Regions may meet: a feed wins over a line, a line over an end. So the corner of an end
//! and an arc edge is booked to the edge, through which oil is dragged, and no flow is counted twice.

use std::collections::{HashMap, HashSet};

use oilwedge_fem::{Constraints, Space};
use oilwedge_mesh::Mesh;
use oilwedge_mesh::locate::Locator;

use crate::Bearing;

/// What kind of place a region is; all but one give a pressure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum BoundaryKind {
    /// An axial end that nothing flows through and at which no pressure is given.
    Sealed,
    /// An axial end of the bearing.
    End,
    /// An edge of an arc, or the line of a film start.
    Line,
    /// A hole or groove that oil is fed through.
    Feed,
}

/// A round hole on the developed surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Disc {
    /// Centre `(x = R phi, z)` [m].
    pub centre: [f64; 2],
    /// Radius [m].
    pub radius: f64,
}

/// One region of given pressure.
#[derive(Debug, Clone, PartialEq)]
pub struct SupplyRegion {
    /// Name (of the mesh group).
    pub name: String,
    /// Kind of place.
    pub kind: BoundaryKind,
    /// Pressure [Pa gauge].
    pub pressure: f64,
    /// Edges of the mesh.
    pub edges: Vec<u32>,
    /// Cells of the mesh.
    pub cells: Vec<u32>,
    /// Exact shape of the region, where it is round.
    pub disc: Option<Disc>,
    /// Film fraction of the oil that the journal carries in at a starved edge of an arc, where a mass-conserving
    /// film finds its pressure; none where the edge is flooded.
    pub film_fraction: Option<f64>,
}

/// Why the given pressures do not fit the mesh.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SupplyError {
    /// Part of the boundary has no condition.
    #[error("{count} boundary edges belong to no group with a pressure, one near ({x:.6}, {z:.6}) m")]
    Unassigned {
        /// Number of such edges.
        count: usize,
        /// Developed position [m].
        x: f64,
        /// Axial position [m].
        z: f64,
    },
    /// Two feeds with different pressures share a node.
    #[error("feeds \"{first}\" and \"{second}\" touch but have different pressures")]
    Conflict {
        /// Name of a feed.
        first: String,
        /// Name of the other.
        second: String,
    },
    /// The rim of a cut-out does not close.
    #[error(
        "the rim of \"{name}\" is not closed (loose end at node {node}); a region cut out of the film needs a closed curve"
    )]
    OpenRim {
        /// Name of the region.
        name: String,
        /// Node tag in the mesh file.
        node: u64,
    },
    /// No line of element edges at the angle of the film start.
    #[error("no line of element edges runs from end to end at {degrees:.6} deg, where the film is to start")]
    NoLine {
        /// Angle asked for [deg].
        degrees: f64,
    },
}

/// The regions of a film, on a space.
#[derive(Debug, Clone)]
pub struct Supply {
    regions: Vec<SupplyRegion>,
    /// Region of each dof, by index; none for a free dof.
    owner: Vec<Option<u16>>,
}

impl Supply {
    /// Gives each dof on a region to it.
    ///
    /// # Errors
    /// Everything that does not fit.
    pub fn new(space: &Space, mut regions: Vec<SupplyRegion>) -> Result<Self, Vec<SupplyError>> {
        regions.sort_by_key(|region| region.kind);
        let mut errors = Vec::new();
        let mut owner: Vec<Option<u16>> = vec![None; space.dofs()];
        for (index, region) in (0u16..).zip(&regions) {
            let mut conflict = None;
            for dof in given_dofs(space, region) {
                let other = owner[dof].map(|other| &regions[usize::from(other)]);
                conflict = conflict.or(other.filter(|other| {
                    other.name != region.name
                        && other.kind == BoundaryKind::Feed
                        && region.kind == BoundaryKind::Feed
                        && other.pressure != region.pressure
                }));
                owner[dof] = Some(index);
            }
            if let Some(other) = conflict {
                errors.push(SupplyError::Conflict { first: other.name.clone(), second: region.name.clone() });
            }
            errors.extend(open_rim(space.mesh(), &regions, region));
        }
        errors.extend(unassigned(space, &regions, &owner));
        if errors.is_empty() { Ok(Self { regions, owner }) } else { Err(errors) }
    }

    /// The given pressures on another space of their mesh.
    pub(crate) fn on_space(&self, space: &Space) -> Self {
        let mut owner = vec![None; space.dofs()];
        for (index, region) in (0u16..).zip(&self.regions) {
            for dof in given_dofs(space, region) {
                owner[dof] = Some(index);
            }
        }
        Self { regions: self.regions.clone(), owner }
    }

    /// The given pressures on a coarser mesh of the liner, which has ends and lines of its own but no feeds: those take
    /// the dofs that lie in them, one at least. None if the coarser mesh lacks a line.
    pub(crate) fn on_coarser(&self, fine: &Space, coarse: &Space, bearing: &Bearing) -> Option<Self> {
        let mut regions = self.regions.clone();
        for region in &mut regions {
            region.cells.clear();
            region.edges = match (coarse.mesh().region(&region.name), region.kind, region.edges.first()) {
                (_, BoundaryKind::Feed, _) | (_, _, None) => Vec::new(),
                (Some(same), ..) => same.edges.clone(),
                (None, _, Some(&edge)) => {
                    let angle = fine.mesh().edge_nodes(edge)[0][0] / bearing.radius;
                    line_at_angle(coarse.mesh(), bearing.radius, bearing.length, angle).ok()?
                }
            };
        }
        let mut owner = vec![None; coarse.dofs()];
        for (index, region) in (0u16..).zip(&regions) {
            for dof in given_dofs(coarse, region) {
                owner[dof] = Some(index);
            }
        }
        self.sample_feeds(fine, coarse, &mut owner);
        Some(Self { regions, owner })
    }

    fn sample_feeds(&self, fine: &Space, coarse: &Space, owner: &mut [Option<u16>]) {
        let is_feed = |region: &u16| self.regions[usize::from(*region)].kind == BoundaryKind::Feed;
        let feed_at = |dof: usize| self.owner[dof].filter(is_feed);
        let locator = Locator::new(fine.mesh());
        let positions = coarse.positions();
        for (dof, &position) in positions.iter().enumerate() {
            let inside = locator.find(position);
            let Some((triangle, _)) = inside.or_else(|| locator.nearest(position)) else {
                continue;
            };
            let mut owners = fine.element_dofs(triangle).into_iter().take(fine.shapes()).map(feed_at);
            let feed = match inside {
                // In a meshed feed all nodes of the triangle are its own.
                Some(_) => owners.clone().all(|feed| feed.is_some()).then(|| owners.next().flatten()).flatten(),
                None => owners.flatten().next(),
            };
            owner[dof] = feed.or(owner[dof]);
        }
        let fine_positions = fine.positions();
        for index in (0u16..).zip(&self.regions).filter(|(_, region)| region.kind == BoundaryKind::Feed).map(|(k, _)| k)
        {
            let first = (0..fine.dofs()).find(|&dof| self.owner[dof] == Some(index));
            let Some(first) = first.filter(|_| !owner.contains(&Some(index))) else {
                continue;
            };
            let target = fine_positions[first];
            let distance = |dof: usize| (positions[dof][0] - target[0]).hypot(positions[dof][1] - target[1]);
            let nearest = (0..coarse.dofs()).min_by(|&a, &b| distance(a).total_cmp(&distance(b)));
            if let Some(nearest) = nearest {
                owner[nearest] = Some(index);
            }
        }
    }

    /// Dofs that lie in two regions: that which owns the dof, and the one it takes it from.
    pub(crate) fn meeting(&self, space: &Space) -> Vec<(usize, [usize; 2])> {
        let mut found = Vec::new();
        for (index, region) in self.regions.iter().enumerate() {
            for dof in given_dofs(space, region) {
                if let Some(owner) = self.owner(dof).filter(|&owner| owner != index) {
                    found.push((dof, [owner, index]));
                }
            }
        }
        found.sort_unstable();
        found.dedup();
        found
    }

    /// Feeds and what they meet at another pressure, where the flow from the one to the other has no limit: names.
    pub fn jumps(&self, space: &Space) -> Vec<[&str; 2]> {
        let mut jumps: Vec<[&str; 2]> = (self.meeting(space).into_iter())
            .map(|(_, regions)| regions.map(|index| &self.regions[index]))
            .filter(|[owner, other]| owner.kind == BoundaryKind::Feed && owner.pressure != other.pressure)
            .map(|regions| regions.map(|region| region.name.as_str()))
            .collect();
        jumps.sort_unstable();
        jumps.dedup();
        jumps
    }

    /// The regions: ends, then lines, then feeds.
    pub fn regions(&self) -> &[SupplyRegion] {
        &self.regions
    }

    /// Whether feeds that touch have equal pressures [Pa] by `pressure`.
    pub(crate) fn fits(&self, space: &Space, pressure: &dyn Fn(&SupplyRegion) -> f64) -> bool {
        self.meeting(space).iter().all(|&(_, regions)| {
            let [a, b] = regions.map(|index| &self.regions[index]);
            a.kind != BoundaryKind::Feed || b.kind != BoundaryKind::Feed || pressure(a) == pressure(b)
        })
    }

    /// Gives each region the pressure [Pa] that `pressure` has for it.
    pub(crate) fn set_pressures(&mut self, pressure: &dyn Fn(&SupplyRegion) -> f64) {
        for region in &mut self.regions {
            region.pressure = pressure(region);
        }
    }

    /// Gives each region the exact shape that `disc` has for it.
    pub(crate) fn set_discs(&mut self, disc: &dyn Fn(&SupplyRegion) -> Option<Disc>) {
        for region in &mut self.regions {
            region.disc = disc(region);
        }
    }

    /// Given values at dofs, each the `unknown(pressure)` of its region.
    pub fn constraints(&self, unknown: impl Fn(f64) -> f64) -> Constraints {
        let mut constraints = Constraints::none(self.owner.len());
        for (dof, owner) in self.owner.iter().enumerate() {
            if let Some(region) = owner {
                constraints.fix(dof, unknown(self.regions[usize::from(*region)].pressure));
            }
        }
        constraints
    }

    /// True for each triangle of the film: not those of a region of given pressure.
    pub(crate) fn film(&self, mesh: &Mesh) -> Vec<bool> {
        let mut is_film = vec![true; mesh.triangles().len()];
        for &cell in self.regions.iter().flat_map(|region| &region.cells) {
            is_film[cell as usize] = false;
        }
        is_film
    }

    /// Index of the region that dof `dof` belongs to.
    pub fn owner(&self, dof: usize) -> Option<usize> {
        self.owner[dof].map(usize::from)
    }
}

/// Dofs on the edges and in the cells of a region, if it gives a pressure; some come more than once.
fn given_dofs<'a>(space: &'a Space, region: &'a SupplyRegion) -> impl Iterator<Item = usize> + 'a {
    let on_edges = region.edges.iter().flat_map(|&edge| space.dofs_on_edge(edge));
    let on_cell = |&cell: &u32| space.element_dofs(cell as usize).into_iter().take(space.shapes());
    let all = on_edges.chain(region.cells.iter().flat_map(on_cell));
    all.filter(|_| region.kind != BoundaryKind::Sealed)
}

/// Edges of `region` along which it is cut out of the film: those with a triangle on one side only.
pub fn rim<'a>(mesh: &'a Mesh, region: &'a SupplyRegion) -> impl Iterator<Item = u32> + 'a {
    region
        .edges
        .iter()
        .copied()
        .filter(move |&edge| region.kind == BoundaryKind::Feed && mesh.topology().is_boundary(edge))
}

/// Each vertex of a closed rim has an even number of its edges. The rim of a groove that reaches from end to end is
/// closed by the ends.
fn open_rim(mesh: &Mesh, regions: &[SupplyRegion], region: &SupplyRegion) -> Option<SupplyError> {
    let mut count: HashMap<u32, usize> = HashMap::new();
    for edge in rim(mesh, region) {
        for vertex in mesh.topology().edges[edge as usize] {
            *count.entry(vertex).or_default() += 1;
        }
    }
    let is_end = |other: &&SupplyRegion| matches!(other.kind, BoundaryKind::Sealed | BoundaryKind::End);
    let at_ends: HashSet<u32> = (regions.iter().filter(is_end))
        .flat_map(|end| end.edges.iter().flat_map(|&edge| mesh.topology().edges[edge as usize]))
        .collect();
    let loose = count
        .into_iter()
        .filter(|(vertex, n)| n % 2 == 1 && !at_ends.contains(vertex))
        .map(|(vertex, _)| vertex)
        .min()?;
    Some(SupplyError::OpenRim { name: region.name.clone(), node: mesh.label(loose) })
}

fn unassigned(space: &Space, regions: &[SupplyRegion], owner: &[Option<u16>]) -> Option<SupplyError> {
    let mesh = space.mesh();
    let sealed = regions.iter().filter(|region| region.kind == BoundaryKind::Sealed);
    let sealed: HashSet<u32> = sealed.flat_map(|region| region.edges.iter().copied()).collect();
    let bare: Vec<u32> = (0..mesh.topology().edges.len() as u32)
        .filter(|&edge| mesh.topology().is_boundary(edge) && !sealed.contains(&edge))
        .filter(|&edge| space.dofs_on_edge(edge).any(|dof| owner[dof].is_none()))
        .collect();
    let [x, z] = mesh.edge_nodes(*bare.first()?)[2];
    Some(SupplyError::Unassigned { count: bare.len(), x, z })
}

/// Edges that run along `x = R phi` at the angle `angle` [rad], from end to end. Where the line meets a
/// region that is cut out it may be interrupted: the oil there has a pressure of its own.
///
/// # Errors
/// [`SupplyError::NoLine`] if they do not make up the length of the bearing.
pub fn line_at_angle(mesh: &Mesh, radius: f64, length: f64, angle: f64) -> Result<Vec<u32>, SupplyError> {
    let missing = SupplyError::NoLine { degrees: angle.to_degrees() };
    let topology = mesh.topology();
    let on_line = |v: u32| {
        let turns = (mesh.points()[v as usize][0] / radius - angle) / std::f64::consts::TAU;
        (turns - turns.round()).abs() < 1e-8
    };
    let z = |v: u32| mesh.points()[v as usize][1];
    let edges: Vec<u32> = (0u32..)
        .zip(&topology.edges)
        .filter(|(edge, ends)| ends.iter().all(|&v| on_line(v)) && mesh.bulge(*edge) == [0.0; 2])
        .map(|(edge, _)| edge)
        .collect();
    let mut spans: Vec<[u32; 2]> = (edges.iter().map(|&edge| topology.edges[edge as usize]))
        .map(|[a, b]| if z(a) < z(b) { [a, b] } else { [b, a] })
        .collect();
    spans.sort_unstable_by(|a, b| z(a[0]).total_cmp(&z(b[0])));
    let near = 1e-6 * length;
    let (Some(first), Some(last)) = (spans.first(), spans.last()) else {
        return Err(missing);
    };
    let mut rim = vec![false; mesh.points().len()];
    for edge in (0..topology.edges.len() as u32).filter(|&edge| topology.is_boundary(edge)) {
        for v in topology.edges[edge as usize] {
            rim[v as usize] = true;
        }
    }
    let whole = spans.windows(2).all(|pair| {
        let (end, start) = (pair[0][1], pair[1][0]);
        end == start || (rim[end as usize] && rim[start as usize])
    });
    let reaches = z(last[1]) - z(first[0]) > length - near;
    if whole && reaches { Ok(edges) } else { Err(missing) }
}
