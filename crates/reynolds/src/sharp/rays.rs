//! Rays along the flow: where the film is full on each, where cavities begin and end, and the oil that they carry on.
//!
//! A ray z = const cuts the sub-triangles of the mass-conserving film in intervals on which the pressure is linear:
//! full where one end has a pressure, else part of a cavity. Along the flow `h theta` does not change within a cavity,
//! so that one value is carried over each: that in its middle, the **switch**, which is as far from both of its ends as
//! a place can be.

use oilwedge_fem::Space;
use oilwedge_fem::control_volumes::sub_triangles;
use oilwedge_mesh::Mesh;

use crate::supply::{BoundaryKind, SupplyRegion};
use crate::{FilmSystem, SolvedFilm};

/// Rays over the length of the bearing.
const RAYS: usize = 320;
/// A pressure below this part of the greatest one is none.
const NO_PRESSURE: f64 = 1e-9;
/// The corners of a triangle that is full everywhere.
const WHOLE: &[[usize; 3]] = &[[0, 1, 2]];
/// A gap on a ray that is wider than this part of its length is a region cut out of the film.
const GAP: f64 = 1e-9;

/// Rays at equal distances.
#[derive(Debug)]
pub(super) struct Rays {
    /// Place [m] along the axis of the lower end, and the distance of two rays.
    low: f64,
    step: f64,
    /// One if the journal's surface moves towards +x, else minus one: places on a ray grow along the flow.
    towards: f64,
    period: Option<f64>,
    /// True at dofs of the mass-conserving film with a pressure.
    full: Vec<bool>,
    rays: Vec<Ray>,
}

/// What a place on a ray belongs to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum RaySide {
    /// The film, or the part of a cavity behind it.
    Rupture,
    /// The part of a cavity before the film forms again, or that film: oil of this thickness [m] arrives.
    Reformation(f64),
    /// A ray on which the film is nowhere full.
    Bare,
}

/// A ray.
#[derive(Debug, Default)]
struct Ray {
    /// Place at which the ray begins [m].
    start: f64,
    /// True if the film is full somewhere.
    has_film: bool,
    /// Reformations along the ray, in ascending order.
    reformations: Vec<Reformation>,
}

/// Place at which oil of a cavity arrives.
#[derive(Debug, Clone, Copy)]
struct Reformation {
    switch: f64,
    /// The end of what is counted as its side.
    until: f64,
    /// `h theta` [m] at the switch.
    oil: f64,
    source: OilSource,
}

/// Where the oil of a cavity is taken from: the point at which a ray enters a sub-triangle of the mass-conserving film.
#[derive(Debug, Clone, Copy)]
struct OilSource {
    holder: Holder,
    /// Barycentric coordinates.
    weights: [f64; 3],
}

/// A sub-triangle, of a piece of the film.
#[derive(Debug, Clone, Copy, Default)]
struct Holder {
    triangle: u32,
    corners: [u8; 3],
}

/// A piece of a ray.
#[derive(Debug, Clone, Copy)]
struct RayPiece {
    from: f64,
    to: f64,
    kind: RegionKind,
    holder: Holder,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum RegionKind {
    Full,
    Cavity,
    /// A region where pressure is given, and the film full.
    Supply,
}

impl Rays {
    /// The rays of a mass-conserving film; oil of these thicknesses [m] leaves its nodes.
    pub(super) fn new(film: &SolvedFilm, oil: &[f64]) -> Self {
        let SolvedFilm { problem, system, .. } = film;
        let mesh = system.space().mesh();
        let (low, high) = (mesh.points().iter())
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), point| (l.min(point[1]), h.max(point[1])));
        let mut rays = Self {
            low,
            step: (high - low) / RAYS as f64,
            towards: problem.surface_velocity()[0].signum(),
            period: mesh.period(),
            full: full(film),
            rays: Vec::new(),
        };
        let mut pieces = vec![Vec::new(); RAYS];
        rays.cut(system, &mut pieces);
        for region in system.supply.regions().iter().filter(|region| is_flooded_line(region)) {
            rays.add_line(mesh, region, &mut pieces);
        }
        let on_rays = pieces.into_iter().enumerate();
        rays.rays = on_rays.map(|(ray, pieces)| rays.ray(mesh, ray, pieces)).collect();
        rays.refill(system.space(), oil);
        rays
    }

    /// True if these are also the rays of another film on the same mesh, but for the oil.
    pub(super) fn are_those_of(&self, film: &SolvedFilm) -> bool {
        self.full == full(film)
    }

    /// Takes the oil of the film at another position, with cavities and the places from which it comes as they are.
    pub(super) fn refill(&mut self, space: &Space, oil: &[f64]) {
        for reformation in self.rays.iter_mut().flat_map(|ray| &mut ray.reformations) {
            let OilSource { holder, weights } = reformation.source;
            let dofs = space.element_dofs(holder.triangle as usize);
            let at_corner = |k: u8| oil[dofs[usize::from(k)]];
            reformation.oil = holder.corners.iter().zip(weights).map(|(&k, weight)| weight * at_corner(k)).sum();
        }
    }

    /// Pieces of all sub-triangles.
    fn cut(&self, system: &FilmSystem, pieces: &mut [Vec<RayPiece>]) {
        let (space, mesh) = (system.space(), system.space().mesh());
        let is_feed = |dof: usize| {
            let owner = system.supply.owner(dof).map(|owner| system.supply.regions()[owner].kind);
            owner == Some(BoundaryKind::Feed)
        };
        for t in 0..mesh.triangles().len() {
            let (nodes, dofs) = (mesh.nodes(t), space.element_dofs(t));
            let dofs = &dofs[..space.shapes()];
            let is_plain = !mesh.is_curved(t) && !dofs.iter().any(|&dof| is_feed(dof));
            let subs = match is_plain && dofs.iter().all(|&dof| self.full[dof]) {
                true => WHOLE,
                false => sub_triangles(space, t),
            };
            for corners in subs {
                let at = corners.map(|k| nodes[k]);
                let full = corners.map(|k| self.full[dofs[k]]);
                let is_fed = corners.iter().all(|&k| is_feed(dofs[k]));
                for ray in self.across(at) {
                    let Some(ends) = self.crossing(ray, at) else {
                        continue;
                    };
                    let has_pressure = |(_, weights): &(f64, [f64; 3])| (0..3).any(|k| full[k] && weights[k] > 0.0);
                    let kind = match ends.iter().any(has_pressure) {
                        _ if is_fed => RegionKind::Supply,
                        true => RegionKind::Full,
                        false => RegionKind::Cavity,
                    };
                    pieces[ray].push(RayPiece {
                        from: ends[0].0,
                        to: ends[1].0,
                        kind,
                        holder: Holder { triangle: t as u32, corners: corners.map(|k| k as u8) },
                    });
                }
            }
        }
    }

    /// Place [m] of a ray along the axis.
    fn z(&self, ray: usize) -> f64 {
        self.low + self.step * (ray as f64 + 0.5)
    }

    /// Rays that may cross a triangle.
    fn across(&self, corners: [[f64; 2]; 3]) -> std::ops::Range<usize> {
        let (low, high) =
            corners.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), at| (l.min(at[1]), h.max(at[1])));
        let place = |z: f64| ((z - self.low) / self.step - 0.5).max(0.0);
        place(low) as usize..(place(high) as usize + 2).min(RAYS)
    }

    /// Where a ray enters and leaves a triangle, with the barycentric coordinates there. A corner on the ray counts as
    /// above it.
    fn crossing(&self, ray: usize, corners: [[f64; 2]; 3]) -> Option<[(f64, [f64; 3]); 2]> {
        let z = self.z(ray);
        let mut found = [None; 2];
        let mut count = 0;
        for k in 0..3 {
            let (a, b) = (k, (k + 1) % 3);
            let (below, above) = (corners[a][1] - z, corners[b][1] - z);
            if (below >= 0.0) == (above >= 0.0) {
                continue;
            }
            let s = below / (below - above);
            let x = corners[a][0] + s * (corners[b][0] - corners[a][0]);
            let mut weights = [0.0; 3];
            (weights[a], weights[b]) = (1.0 - s, s);
            found[count] = Some((self.towards * x, weights));
            count += 1;
        }
        let (first, last) = (found[0]?, found[1]?);
        Some(if first.0 <= last.0 { [first, last] } else { [last, first] })
    }

    /// Adds the place of a flooded line to all rays.
    fn add_line(&self, mesh: &Mesh, region: &SupplyRegion, pieces: &mut [Vec<RayPiece>]) {
        let Some(&edge) = region.edges.first() else { return };
        let x = self.towards * mesh.edge_nodes(edge)[0][0];
        for pieces in pieces {
            pieces.push(RayPiece { from: x, to: x, kind: RegionKind::Supply, holder: Holder::default() });
        }
    }

    /// The ray that these pieces make.
    fn ray(&self, mesh: &Mesh, ray: usize, mut pieces: Vec<RayPiece>) -> Ray {
        let middle = |piece: &RayPiece| 0.5 * (piece.from + piece.to);
        if let (Some(period), Some(first)) = (self.period, pieces.first().map(middle)) {
            for piece in &mut pieces {
                let turns = ((middle(piece) - first) / period).floor();
                piece.from -= turns * period;
                piece.to -= turns * period;
            }
        }
        pieces.sort_by(|a, b| middle(a).total_cmp(&middle(b)));
        // Oil leaves by the last line of an arc, and none comes in there.
        while self.period.is_none() && pieces.last().is_some_and(|last| last.from == last.to) {
            pieces.pop();
        }
        let mut pieces = self.joined(pieces);
        let has_film = pieces.iter().any(|piece| piece.kind != RegionKind::Cavity);
        if !has_film || pieces.iter().all(|piece| piece.kind != RegionKind::Cavity) {
            return Ray { has_film, ..Ray::default() };
        }
        if let Some(period) = self.period {
            turned(&mut pieces, period);
        }
        let reformations = (0..pieces.len()).filter_map(|k| self.reformation(mesh, ray, &pieces, k));
        Ray { start: pieces[0].from, has_film, reformations: reformations.collect() }
    }

    /// Pieces with those of supplies cut out of the mesh between them.
    fn joined(&self, pieces: Vec<RayPiece>) -> Vec<RayPiece> {
        let mut joined: Vec<RayPiece> = Vec::with_capacity(pieces.len() + 1);
        let Some(&first) = pieces.first() else { return joined };
        let length = pieces[pieces.len() - 1].to - first.from;
        let supply = |from: f64, to: f64| RayPiece { from, to, kind: RegionKind::Supply, holder: Holder::default() };
        for piece in pieces {
            let end = joined.last().map_or(piece.from, |last: &RayPiece| last.to);
            if piece.from - end > GAP * length {
                joined.push(supply(end, piece.from));
            }
            joined.push(piece);
        }
        let end = joined[joined.len() - 1].to;
        if let Some(period) = self.period.filter(|period| first.from + period - end > GAP * length) {
            joined.push(supply(end, first.from + period));
        }
        joined
    }

    /// The side of reformation of the cavity that begins with piece `k`, if one does.
    fn reformation(&self, mesh: &Mesh, ray: usize, pieces: &[RayPiece], k: usize) -> Option<Reformation> {
        let is_cavity = |k: usize| pieces.get(k).is_some_and(|piece| piece.kind == RegionKind::Cavity);
        // On an arc only a starved edge lets a cavity in.
        let is_starved = k == 0 && self.period.is_none();
        if !is_cavity(k) || (k > 0 && is_cavity(k - 1)) {
            return None;
        }
        let cavity = &pieces[k..];
        let length = cavity.iter().take_while(|piece| piece.kind == RegionKind::Cavity).count();
        let (cavity, film) = cavity.split_at(length);
        let end = film.first()?.from;
        let switch = match is_starved {
            true => cavity[0].from,
            false => 0.5 * (cavity[0].from + end),
        };
        let piece = cavity.iter().find(|piece| piece.to >= switch)?;
        let nodes = mesh.nodes(piece.holder.triangle as usize);
        let [(_, weights), _] = self.crossing(ray, piece.holder.corners.map(|k| nodes[usize::from(k)]))?;
        let full = film.iter().take_while(|piece| piece.kind != RegionKind::Cavity);
        let full_end = full.clone().last()?.to;
        let supply = full.clone().find(|piece| piece.kind == RegionKind::Supply);
        let middle = 0.5 * (end + full_end);
        Some(Reformation {
            switch,
            until: supply.map_or(middle, |supply| middle.min(supply.from)),
            oil: 0.0,
            source: OilSource { holder: piece.holder, weights },
        })
    }

    /// What a place [m] belongs to: of the two rays beside it where both agree, else of the nearer one.
    pub(super) fn side(&self, [x, z]: [f64; 2]) -> RaySide {
        let place = ((z - self.low) / self.step - 0.5).clamp(0.0, (RAYS - 1) as f64);
        let below = (place as usize).min(RAYS - 2);
        let part = place - below as f64;
        match [below, below + 1].map(|ray| self.side_on(ray, x)) {
            [RaySide::Reformation(a), RaySide::Reformation(b)] => RaySide::Reformation(a + part * (b - a)),
            [_, side] if part > 0.5 => side,
            [side, _] => side,
        }
    }

    /// What each dof belongs to.
    pub(super) fn sides(&self, space: &Space) -> Vec<RaySide> {
        space.positions().iter().map(|&position| self.side(position)).collect()
    }

    fn side_on(&self, ray: usize, x: f64) -> RaySide {
        let ray = &self.rays[ray];
        if !ray.has_film {
            return RaySide::Bare;
        }
        let mut at = self.towards * x;
        if let Some(period) = self.period {
            at -= ((at - ray.start) / period).floor() * period;
        }
        let next = ray.reformations.partition_point(|reformation| reformation.switch < at);
        match next.checked_sub(1).map(|k| ray.reformations[k]) {
            Some(reformation) if at < reformation.until => RaySide::Reformation(reformation.oil),
            _ => RaySide::Rupture,
        }
    }
}

/// Begins with a cavity that has no other before it, after a full film.
fn turned(pieces: &mut [RayPiece], period: f64) {
    let count = pieces.len();
    let is_cavity = |k: usize| pieces[k % count].kind == RegionKind::Cavity;
    let begin = (0..count).find(|&k| is_cavity(k) && !is_cavity(k + count - 1)).unwrap_or(0);
    for piece in &mut pieces[..begin] {
        piece.from += period;
        piece.to += period;
    }
    pieces.rotate_left(begin);
}

/// True at dofs with a pressure.
fn full(film: &SolvedFilm) -> Vec<bool> {
    let (unknown, floor) = (&film.solution.unknown, film.problem.cavity_unknown());
    let greatest = unknown.iter().fold(0.0f64, |most, u| most.max(u - floor));
    let is_full = |u: &f64| u - floor > NO_PRESSURE * greatest;
    unknown.iter().map(is_full).collect()
}

/// Lines along which the film is full at a given pressure.
fn is_flooded_line(region: &SupplyRegion) -> bool {
    region.kind == BoundaryKind::Line && region.film_fraction.is_none()
}
