//! What an uncertain deflection of the wall makes uncertain.
//!
//! Both films of a pair run under one wall, bent by the film that is reported. The wall would be bent otherwise by the pressure of the other film, and on a finer grid:
//! as far as the wall would move, film and wall answer along their common tangent, and the film is measured again.

use std::borrow::Cow;
use std::collections::HashMap;

use oilwedge_bearing::deflection::bent;
use oilwedge_reynolds::FilmSystem;
use oilwedge_reynolds::quantities::contact_points::ContactPoints;
use oilwedge_reynolds::quantities::load::{Resultant, load};

use super::position_sensitivity::with_dynamics;
use crate::measure::{Measured, measure};
use crate::quantities::{Quantity, View, measured};
use crate::solved::Solved;

/// What the deflection lets numbers change by.
#[derive(Debug, Default)]
pub(super) struct WallBars {
    /// Quantities by name; not finite where the film has no tangent.
    by_name: HashMap<Cow<'static, str>, f64>,
    /// Forces towards x and y [N], and moments [N m], at a fixed position.
    forces: [f64; 4],
}

impl WallBars {
    /// Change of the quantity of this name; zero of a rigid wall.
    pub(super) fn of(&self, name: &str) -> f64 {
        self.by_name.get(name).copied().unwrap_or(0.0)
    }

    /// Changes of the force along a load [N] and across it, and of the moments [N m].
    pub(super) fn along(&self, [x, y]: [f64; 2]) -> [f64; 4] {
        let size = x.hypot(y);
        let [along, across] = if size > 0.0 { [x / size, y / size] } else { [1.0, 0.0] };
        let [f_x, f_y, m_x, m_y] = self.forces;
        // Signs are lost: both parts count to both sides.
        [
            f_x * along.abs() + f_y * across.abs(),
            f_x * across.abs() + f_y * along.abs(),
            m_x,
            m_y,
        ]
    }
}

/// For each quantity of `list`, numbers of the film itself, how much it changes with what is uncertain of the wall.
pub(super) fn wall_bars(solved: &Solved, list: &[Quantity], reported: &Measured) -> WallBars {
    let film = &solved.film;
    let (problem, system) = (&film.problem, &film.system);
    let mut bars = WallBars::default();
    let Some(deflection) = problem.deflection() else {
        return bars;
    };
    let here = load(problem, system, &solved.solution).total.resultant();
    let wall = &deflection.wall;
    let by_other = solved.reference.as_ref().map(|reference| {
        let by = |system: &FilmSystem, unknown: &[f64]| {
            let contact = ContactPoints::of(problem, system);
            wall.deflection((problem, system), unknown, contact.as_ref())
        };
        let own = by(system, &solved.solution.unknown);
        let other = by(reference.system(system), &reference.film().unknown);
        other
            .iter()
            .zip(own)
            .map(|(other, own)| other - own)
            .collect::<Vec<f64>>()
    });
    let by_grid = wall.grid_error(problem, system, &solved.solution.unknown);
    for free in [by_other, by_grid].into_iter().flatten() {
        let moved = bent(problem, system, &solved.solution, &free).ok().flatten();
        let there = moved.map(|(problem, film)| {
            let forces = load(&problem, system, &film).total.resultant();
            let there = measure(&problem, system, &film);
            let there = with_dynamics(solved, there, &problem, film, reported);
            (forces, measured(&View::new(&solved.film, &problem, &there)))
        });
        let (forces, numbers) = there.unwrap_or((Resultant::default(), Vec::new()));
        for (change, difference) in bars.forces.iter_mut().zip(differences(&here, &forces)) {
            *change += difference.abs();
        }
        for quantity in list {
            let there = numbers.iter().find(|there| there.name == quantity.name);
            let change = there.map_or(f64::NAN, |there| {
                quantity.row.difference(quantity.value, there.value).abs()
            });
            *bars.by_name.entry(quantity.name.clone()).or_default() += change;
        }
    }
    bars
}

fn differences(a: &Resultant, b: &Resultant) -> [f64; 4] {
    let ([a_x, a_y], [b_x, b_y]) = (a.force, b.force);
    let ([p_x, p_y], [q_x, q_y]) = (a.moment, b.moment);
    [a_x - b_x, a_y - b_y, p_x - q_x, p_y - q_y]
}
