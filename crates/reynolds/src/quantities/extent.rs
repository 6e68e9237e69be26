//! # Where the loaded film begins and where it ruptures
//!
//! **Equation.** On the line z = 0, from the angle of the greatest pressure against the rotation and with it (at rest,
//! with growing phi): the first place in the cavity. Before that the film ends at an edge of an arc, at the line of a
//! film start, and at a feed at the pressure of the cavity that is cut out of the liner.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | x = R phi of both ends | m | `begins`, `ends` |
//!
//! **Source.** The film arc of Raimondi, Boyd, Trans. ASLE 1 (1958) 159; rupture and reformation boundaries of Elrod,
//! J. Lubr. Technol. 103 (1981) 350.
//! **Range.** Models of cavitation; none where the film is full all around, or where the line is cut out of the liner.
//! **Verified by** `tests/full/tests/film_places.rs`.

use oilwedge_fem::Field;
use oilwedge_fem::control_volumes::{sub_triangle_at, sub_triangles};
use oilwedge_fem::field::evaluate;
use oilwedge_fem::mapping::Mapping;

use super::line_cut::{between, cut};
use super::pressure::Extremes;
use crate::film_law::FilmLaw;
use crate::supply::BoundaryKind;
use crate::{FilmSystem, SolvedFilm};

/// What ends a film.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EndKind {
    /// A given line: an edge of an arc, a film start, a feed.
    Line,
    /// The cavity.
    Cavity,
}

/// One end of the loaded film.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FilmEnd {
    /// Place of the end [m], x = R phi.
    pub x: f64,
    /// What it is.
    pub kind: EndKind,
    /// Triangle that it is in or beside.
    pub triangle: usize,
    /// Length [m] within which the mesh cannot resolve where it is: that of the triangle for a front that the film
    /// finds, zero at a given line.
    pub unsure: f64,
}

/// The loaded film on the mid-plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extent {
    /// Upstream end of the loaded film.
    pub begins: FilmEnd,
    /// Downstream end of the loaded film.
    pub ends: FilmEnd,
}

/// Extent of the loaded film around its greatest pressure.
pub fn extent(film: &SolvedFilm, extremes: &Extremes) -> Option<Extent> {
    let pressure = film.problem.cavitation.pressure()?;
    if !extremes.summit.is_above(pressure) {
        return None;
    }
    let line = MidPlane {
        film,
        floor: film.problem.unknown_at(pressure),
        pieces: pieces(&film.system, TOUCHES * film.problem.bearing.radius),
        top: extremes.summit.position[0],
    };
    if line.is_low_at_top() {
        return None;
    }
    let sense = if film.problem.journal.speed < 0.0 { -1.0 } else { 1.0 };
    Some(Extent { begins: line.walk(-sense)?, ends: line.walk(sense)? })
}

/// The part of the line that is in one triangle.
struct LinePiece {
    triangle: usize,
    /// Reference coordinates of its ends, and x [m] there, growing.
    ends: [[f64; 2]; 2],
    x: [f64; 2],
}

/// The line z = 0 across the mesh, in pieces longer than `shortest` [m].
fn pieces(system: &FilmSystem, shortest: f64) -> Vec<LinePiece> {
    let mesh = system.space().mesh();
    let piece = |triangle: usize| {
        let ends = cut(&mesh.corners(triangle), 1, 0.0)?;
        let mapping = Mapping::of(mesh, triangle);
        let x = ends.map(|end| mapping.at(end).position[0]);
        let is_turned = x[0] > x[1];
        Some(LinePiece {
            triangle,
            ends: if is_turned { [ends[1], ends[0]] } else { ends },
            x: [x[0].min(x[1]), x[0].max(x[1])],
        })
    };
    let pieces = (0..mesh.triangles().len()).filter_map(piece);
    // A triangle that the line only touches has none of it.
    pieces.filter(|piece| piece.x[1] - piece.x[0] > shortest).collect()
}

/// A film on the mid-plane.
struct MidPlane<'a> {
    film: &'a SolvedFilm,
    /// The unknown [Pa] in the cavity.
    floor: f64,
    pieces: Vec<LinePiece>,
    top: f64,
}

/// Places of each piece at which the film is looked at.
const SAMPLES: usize = 16;
/// Halvings of the way between a place in the film and one in the cavity.
const HALVINGS: usize = 40;
/// The last part of a piece begins here.
const AT_END: f64 = 1.0 - 1e-6;
/// A piece is shorter than this part of the radius where the line only touches a triangle.
const TOUCHES: f64 = 1e-8;
/// Two pieces are apart from this part of the radius on.
const APART: f64 = 1e-6;

impl MidPlane<'_> {
    /// The end of the film in the direction `sense` from its greatest pressure.
    fn walk(&self, sense: f64) -> Option<FilmEnd> {
        let mut pieces: Vec<(f64, &LinePiece)> =
            self.pieces.iter().map(|piece| (self.way(piece, sense), piece)).collect();
        pieces.retain(|(way, _)| *way >= 0.0);
        pieces.sort_by(|a, b| a.0.total_cmp(&b.0));
        let far = |piece: &LinePiece| if sense > 0.0 { piece.x[1] } else { piece.x[0] };
        let near = |piece: &LinePiece| if sense > 0.0 { piece.x[0] } else { piece.x[1] };
        let mut before: Option<&LinePiece> = None;
        for &(_, piece) in &pieces {
            if let Some(last) = before {
                let gap = self.distance(far(last), near(piece), sense);
                let is_apart = gap > APART * self.film.problem.bearing.radius;
                if self.has_line(near(piece)) || is_apart && !self.is_fed(last.triangle) {
                    return Some(self.at_line(last, far(last)));
                }
            }
            if let Some(end) = self.front_in(piece, sense) {
                return Some(end);
            }
            before = Some(piece);
        }
        let is_ring = self.film.system.space().mesh().period().is_some();
        before.filter(|_| !is_ring).map(|last| self.at_line(last, far(last)))
    }

    /// How far a piece is from the greatest pressure [m]; below zero behind it.
    fn way(&self, piece: &LinePiece, sense: f64) -> f64 {
        // A piece that ends at the greatest pressure is behind it.
        let reach = sense * self.apart(if sense > 0.0 { piece.x[1] } else { piece.x[0] }, self.top);
        match self.has_top(piece) && reach > APART * (piece.x[1] - piece.x[0]) {
            true => 0.0,
            false => self.distance(self.top, 0.5 * (piece.x[0] + piece.x[1]), sense),
        }
    }

    /// True of a piece at the angle of the greatest pressure.
    fn has_top(&self, piece: &LinePiece) -> bool {
        let half = 0.5 * (piece.x[1] - piece.x[0]);
        self.apart(self.top, piece.x[0] + half).abs() <= half
    }

    /// True if the line is in the cavity at the angle of the greatest pressure.
    fn is_low_at_top(&self) -> bool {
        let piece = self.pieces.iter().find(|piece| self.has_top(piece));
        piece.is_some_and(|piece| {
            let part = self.apart(self.top, piece.x[0]) / (piece.x[1] - piece.x[0]);
            self.is_low(piece.triangle, between(&piece.ends[0], &piece.ends[1], part))
        })
    }

    /// The way [m] from one place to another in a direction, less than once around.
    fn distance(&self, from: f64, to: f64, sense: f64) -> f64 {
        let way = sense * (to - from);
        match self.film.system.space().mesh().period() {
            // Rounding is no way around.
            Some(period) => (way + APART * period).rem_euclid(period) - APART * period,
            None => way,
        }
    }

    /// Difference [m] of two places, the lesser way around.
    fn apart(&self, a: f64, b: f64) -> f64 {
        match self.film.system.space().mesh().period() {
            Some(period) => (a - b) - period * ((a - b) / period).round(),
            None => a - b,
        }
    }

    /// True if a line of given pressure is at this place.
    fn has_line(&self, x: f64) -> bool {
        let mesh = self.film.system.space().mesh();
        let regions = self.film.system.supply.regions().iter();
        let lines = regions.filter(|region| region.kind == BoundaryKind::Line);
        let mut places = lines.filter_map(|region| Some(mesh.edge_nodes(*region.edges.first()?)[0][0]));
        places.any(|place| self.apart(place, x).abs() < APART * self.film.problem.bearing.radius)
    }

    /// True if the feed beside a triangle has a greater pressure than the cavity.
    fn is_fed(&self, triangle: usize) -> bool {
        let space = self.film.system.space();
        let dofs = space.element_dofs(triangle);
        let owner = dofs[..space.shapes()].iter().find_map(|&dof| self.film.system.supply.owner(dof));
        let pressure = owner.map(|region| self.film.system.supply.regions()[region].pressure);
        pressure.is_some_and(|pressure| self.film.problem.unknown_at(pressure) > self.floor)
    }

    /// The film ends at a given line. Where it diverges there a cavity may hide in the last triangle.
    fn at_line(&self, piece: &LinePiece, x: f64) -> FilmEnd {
        let law = FilmLaw::new(&self.film.problem, 1.0);
        let middle = [0.5 * (piece.x[0] + piece.x[1]), 0.0];
        let flow = law.film_and_flows(piece.triangle, &[middle]).1[0];
        FilmEnd {
            x,
            kind: EndKind::Line,
            triangle: piece.triangle,
            unsure: match flow.divergence + flow.storage > 0.0 {
                true => self.width(piece.triangle),
                false => 0.0,
            },
        }
    }

    /// The first place in the cavity in a piece, if there is one.
    fn front_in(&self, piece: &LinePiece, sense: f64) -> Option<FilmEnd> {
        let along = |s: f64| if sense > 0.0 { s } else { 1.0 - s };
        let x = |s: f64| piece.x[0] + along(s) * (piece.x[1] - piece.x[0]);
        let is_low = |s: f64| {
            let is_behind = sense * self.apart(x(s), self.top) < 0.0
                && self.apart(x(s), self.top).abs() < self.width(piece.triangle);
            !is_behind && self.is_low(piece.triangle, between(&piece.ends[0], &piece.ends[1], along(s)))
        };
        let places = (1..=SAMPLES).map(|k| k as f64 / SAMPLES as f64);
        let mut full = 0.0;
        for place in places {
            if is_low(place) {
                let mut low = if full == 0.0 && is_low(0.0) { 0.0 } else { place };
                for _ in 0..HALVINGS {
                    let middle = 0.5 * (full + low);
                    *if is_low(middle) { &mut low } else { &mut full } = middle;
                }
                // At the end of a piece what comes next tells: a given line, or a cavity.
                return (low < AT_END).then(|| FilmEnd {
                    x: x(low),
                    kind: EndKind::Cavity,
                    triangle: piece.triangle,
                    unsure: match self.film.problem.cavitation.has_free_boundary() {
                        true => self.width(piece.triangle),
                        false => 0.0,
                    },
                });
            }
            full = place;
        }
        None
    }

    /// Extent [m] of a triangle along x.
    fn width(&self, triangle: usize) -> f64 {
        let xs = self.film.system.space().mesh().corners(triangle).map(|corner| corner[0]);
        xs.iter().fold(f64::NEG_INFINITY, |most, &x| most.max(x))
            - xs.iter().fold(f64::INFINITY, |least, &x| least.min(x))
    }

    /// True in the cavity.
    fn is_low(&self, triangle: usize, point: [f64; 2]) -> bool {
        let (space, film) = (self.film.system.space(), &self.film.solution);
        let (degree, dofs) = (space.degree(), space.element_dofs(triangle));
        let nodal = Field { space, values: &film.unknown }.element_values(triangle);
        if film.film_fraction.is_some() {
            return self.is_carried(triangle, point);
        }
        let held = |i: usize| film.cavity[dofs[i]];
        // Quadratics are held amid edges only.
        let mut tested = if degree == 2 { 3..6 } else { 0..space.shapes() };
        match (tested.clone().all(held), tested.any(held)) {
            (true, _) => true,
            (_, false) if self.film.problem.cavitation.has_free_boundary() => false,
            _ => evaluate(degree, &nodal, point) <= self.floor,
        }
    }

    /// True where more than half of a sub-triangle of a mass-conserving film, by its nodes, is in the cavity.
    fn is_carried(&self, triangle: usize, point: [f64; 2]) -> bool {
        let (space, cavity) = (self.film.system.space(), &self.film.solution.cavity);
        let dofs = space.element_dofs(triangle);
        let (number, weights) = sub_triangle_at(space, triangle, point);
        let corners = sub_triangles(space, triangle)[number].iter().zip(weights);
        corners.filter(|(node, _)| cavity[dofs[**node]]).map(|(_, weight)| weight).sum::<f64>() > 0.5
    }
}
