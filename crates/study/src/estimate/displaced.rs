//! Bars of a film whose place a shaft decides: errors of all films of the shaft move its journal.
//!
//! Each error moves all journals, and changes what the film that makes it carries in its place as well. So what a film
//! carries changes by the sum of both, which cancel where statics alone decides the load. The changes of a number by
//! errors that are independent of each other are added without their signs.

use oilwedge_bearing::coordinates::{Coordinates, Vector, unit};
use oilwedge_bearing::deflection::displaced;
use oilwedge_reynolds::CentreVelocity;
use oilwedge_reynolds::error_bar::Bar;

use super::errors::Estimated;
use crate::measure::{Measured, measure};
use crate::quantities::{ErrorRule, Quantity, View, measured};
use crate::solved::Solved;

/// What one error does to a film.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Displacement {
    /// How far it moves the journal [m].
    pub by: Vector,
    /// What the film carries more in its place [N]; zero where the error is that of another film.
    pub carries: Vector,
}

impl Estimated {
    /// The quantities with the bars of a film that independent `errors` displace; none where they are not known, but of
    /// numbers that follow from given ones.
    #[must_use]
    pub fn displaced(mut self, solved: &Solved, coordinates: Coordinates, errors: Option<&[Displacement]>) -> Self {
        let changes = errors.map(|errors| changes(solved, coordinates, &self.quantities, errors));
        for (number, quantity) in self.quantities.iter_mut().enumerate() {
            let rule = &quantity.row.error;
            let bar = match &changes {
                _ if matches!(rule, ErrorRule::Exact | ErrorRule::Rim) => quantity.bar,
                None => None,
                Some(changes) => quantity.bar.map(|bar| {
                    let position = changes[number];
                    match rule.is_of_load() {
                        true => Bar { position, ..Bar::default() },
                        false => Bar { position, ..bar },
                    }
                }),
            };
            quantity.set_bar(bar);
        }
        self
    }
}

/// How much `errors` change each of these numbers, all together.
fn changes(solved: &Solved, coordinates: Coordinates, list: &[Quantity], errors: &[Displacement]) -> Vec<f64> {
    let film = &solved.primary;
    let here = || measure(film);
    let base = numbers(solved, &film.problem, &here());
    let column = |there: Option<Vec<Quantity>>, size: f64| -> Vec<f64> {
        let change = |quantity: &Quantity| {
            let of = |list: &[Quantity]| Some(list.iter().find(|other| other.name == quantity.name)?.value);
            let both = there.as_deref().and_then(of).zip(of(&base));
            both.map_or(f64::NAN, |(there, here)| quantity.row.difference(there, here) / size)
        };
        list.iter().map(change).collect()
    };
    let size = |part: &dyn Fn(&Displacement) -> f64| errors.iter().map(|error| part(error).abs()).sum::<f64>();
    let by_place = |k: usize| {
        let size = size(&|error| error.by[k]);
        let along = unit(k).map(|part| size * part);
        let change = coordinates.change(&film.problem.journal, &CentreVelocity::default(), along);
        let moved = displaced(film, &change).ok();
        let there = moved.map(|moved| numbers(solved, &moved.problem, &measure(&moved)));
        (size > 0.0).then(|| column(there, size))
    };
    let by_force = |k: usize| {
        let size = size(&|error| error.carries[k]);
        let mut there = here();
        match k {
            0 | 1 => there.load.total.force[k] += size,
            _ => there.load.total.moment[k - 2] += coordinates.arm * size,
        }
        (size > 0.0).then(|| column(Some(numbers(solved, &film.problem, &there)), size))
    };
    let orders = 0..coordinates.order;
    let columns: Vec<_> = orders.map(|k| (k, by_place(k), by_force(k))).collect();
    let change = |number: usize, error: &Displacement| -> f64 {
        let is_of_load = list[number].row.error.is_of_load();
        let part = |column: &Option<Vec<f64>>, by: f64| column.as_ref().map_or(0.0, |column| column[number] * by);
        let parts = columns.iter().map(|(k, by_place, by_force)| {
            let carries = if is_of_load { error.carries[*k] } else { 0.0 };
            part(by_place, error.by[*k]) + part(by_force, carries)
        });
        parts.sum()
    };
    (0..list.len()).map(|number| errors.iter().map(|error| change(number, error).abs()).sum()).collect()
}

fn numbers(solved: &Solved, problem: &oilwedge_reynolds::FilmProblem, of: &Measured) -> Vec<Quantity> {
    measured(&View::new(&solved.film, problem, of))
}
