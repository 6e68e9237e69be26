//! What an uncertain deflection of the wall makes uncertain.
//!
//! Both films of a pair run under one wall, bent by the film that is reported. The wall would be bent otherwise by the
//! pressure of the other film, and on a finer grid: as far as the wall would move, film and wall answer along their
//! common tangent, and the film is measured again. For forces and moments the dual of film and wall
//! ([`oilwedge_reynolds::error_bar::following`]) has the part of the other film, with its sign; the grid's is added
//! here.

use std::borrow::Cow;
use std::collections::HashMap;

use oilwedge_bearing::Vector;
use oilwedge_bearing::deflection::{bent, touched};
use oilwedge_reynolds::film_thickness::Deflection;
use oilwedge_reynolds::quantities::load::{Resultant, load};
use oilwedge_reynolds::{Gap, SolvedFilm, Thinnest};

use super::position_sensitivity::with_dynamics;
use crate::measure::{Measured, measure};
use crate::quantities::{
    FILM_THICKNESS_MIN, FILM_THICKNESS_MIN_ANGLE, FILM_THICKNESS_MIN_Z, Quantity, Row, View, measured,
};
use crate::solved::Solved;

/// What the deflection lets numbers change by.
#[derive(Debug, Default)]
pub(super) struct WallBars {
    /// Quantities by name; not finite where the film has no tangent.
    by_name: HashMap<Cow<'static, str>, f64>,
    /// Forces towards x and y [N], and moments [N m], at a fixed position: what the grid changes, for the dual of the
    /// wall has the rest.
    forces: [f64; 4],
}

/// Why the wall would be bent otherwise.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum By {
    /// The pressure of the other film.
    OtherFilm,
    /// A finer grid.
    Grid,
}

impl WallBars {
    /// Change of the quantity of this name; zero of a rigid wall.
    pub(super) fn of(&self, name: &str) -> f64 {
        self.by_name.get(name).copied().unwrap_or(0.0)
    }

    /// Change of the force [N] in a `direction` of force and moment over this arm [m].
    pub(super) fn towards(&self, direction: Vector, arm: f64) -> f64 {
        let [f_x, f_y, m_x, m_y] = self.forces;
        // Signs are lost: all parts count to all sides.
        let forces = [f_x, f_y, m_x / arm, m_y / arm];
        direction.iter().zip(forces).map(|(part, force)| part.abs() * force).sum()
    }
}

/// Change of each quantity of `list`, numbers of the film itself, with what is uncertain of the wall.
pub(super) fn wall_bars(solved: &Solved, list: &[Quantity], reported: &Measured) -> WallBars {
    let SolvedFilm { problem, system, solution } = &solved.primary;
    let mut bars = WallBars::default();
    let Some(deflection) = problem.deflection() else {
        return bars;
    };
    let here = load(&solved.primary).total.resultant();
    let wall = &deflection.wall;
    let by_other = solved.reference.as_ref().map(|reference| {
        // Contact presses alike under both.
        let by = |film: &SolvedFilm| wall.deflection((problem, &film.system), &film.solution.unknown, None);
        let (own, other) = (by(&solved.primary), by(reference.film()));
        other.iter().zip(own).map(|(other, own)| other - own).collect::<Vec<f64>>()
    });
    let by_grid = wall.grid_error(problem, system, &solution.unknown);
    for (by, free) in [(By::OtherFilm, by_other), (By::Grid, by_grid)] {
        let Some(free) = free else { continue };
        let moved = bent(&solved.primary, &free).ok().flatten();
        let there = moved.map(|moved| {
            let forces = load(&moved).total.resultant();
            let there = with_dynamics(solved, measure(&moved), &moved, reported);
            (forces, measured(&View::new(&solved.film, &moved.problem, &there)))
        });
        let (forces, numbers) = there.unwrap_or((Resultant::default(), Vec::new()));
        let is_in_dual = |quantity: &Quantity| by == By::OtherFilm && quantity.row.error.is_of_load();
        if by == By::Grid {
            for (change, difference) in bars.forces.iter_mut().zip(differences(&here, &forces)) {
                *change += difference.abs();
            }
        }
        for quantity in list.iter().filter(|quantity| !is_in_dual(quantity)) {
            let there = numbers.iter().find(|there| there.name == quantity.name);
            let change = there.map_or(f64::NAN, |there| quantity.row.difference(quantity.value, there.value).abs());
            *bars.by_name.entry(quantity.name.clone()).or_default() += change;
        }
    }
    if let Some(free) = wall.error_at_ends(problem, system, &deflection.coefficients) {
        let thinnest = |deflection: &Deflection| {
            let bent = problem.clone().deflected(Some(deflection));
            Gap::of(&bent, system).thinnest_film(&bent, system)
        };
        // The pressure there is given: contact alone answers.
        let moved = touched(&solved.primary, &free).ok().flatten();
        let [here, there] = [Some(thinnest(deflection)), moved.map(|moved| thinnest(&moved))];
        let mut add = |row: &'static Row, of: fn(Thinnest) -> f64| {
            let change = here.zip(there).map_or(f64::NAN, |(here, there)| row.difference(of(here), of(there)).abs());
            *bars.by_name.entry(row.name.into()).or_default() += change;
        };
        add(&FILM_THICKNESS_MIN, |film| film.thickness);
        add(&FILM_THICKNESS_MIN_ANGLE, |film| film.angle.to_degrees());
        add(&FILM_THICKNESS_MIN_Z, |film| film.z);
    }
    bars
}

fn differences(a: &Resultant, b: &Resultant) -> [f64; 4] {
    let ([a_x, a_y], [b_x, b_y]) = (a.force, b.force);
    let ([p_x, p_y], [q_x, q_y]) = (a.moment, b.moment);
    [a_x - b_x, a_y - b_y, p_x - q_x, p_y - q_y]
}
