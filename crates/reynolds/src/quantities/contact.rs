//! # Contact: what the asperities of journal and liner carry
//!
//! **Equation.** `W_a = Int p_a(h) (cos phi, sin phi) dA`, `m_a = Int p_a z (cos phi, sin phi) dA`, friction `P_a = mu_b |U| Int p_a dA`; over every triangle of the
//! film, in cavities and at the ends too. Where the journal moves, `dW_a = Int p_a'(h) dh (cos phi, sin phi) dA`.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | p_a, p_a' | Pa, Pa/m | [`crate::contact::ContactLaw::at`] |
//! | W_a, m_a | N, N m | `force`, `moment` of [`share`] |
//! | mu_b | 1 | `friction` |
//!
//! The pressure falls to nothing over some roughnesses, far quicker than a film changes: each triangle is quartered, and each part again, until the gap changes little over a part, and
//! further where the law has a kink in it.
//! Contact depends on the gap alone, so that this quadrature, and not the elements of the film, limits its accuracy.
//!
//! **Source.** Definition. **Range.** Friction of contact acts along the surface and carries no load. **Verified by** `tests/tests/contact`.

use std::ops::AddAssign;
use std::sync::LazyLock;

use oilwedge_fem::integrate::{Points, Rule};
use oilwedge_fem::mapping::Mapping;
use oilwedge_fem::quadrature::MOST_POINTS;
use oilwedge_fem::{Quadrature, integrate};

use super::share::{Resultant, Share};
use crate::angles::sines_and_cosines;
use crate::contact::{ContactLaw, ContactPressure};
use crate::{FilmChange, FilmPoint, FilmProblem, FilmSystem};

/// Triangles, and their parts again, are quartered at most this often,
const MOST_QUARTERINGS: usize = 5;
/// until the gap changes by this part of the scale of the law over each part where the pressure is the hardness: an error that falls with the tenth power of the parts
/// is the same for parts that are longer by the tenth root where the pressure is less,
const PART: f64 = 0.5;
const ORDER: f64 = 10.0;
/// and at least so often where the law has a kink in them,
const KINK_QUARTERINGS: usize = 4;
/// where the pressure is more than this part of the hardness.
const SLIGHT: f64 = 1e-10;

/// How finely contact is integrated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Fineness {
    /// As it is reported.
    Full,
    /// With a quartering less, to compare with.
    Halved,
}

/// A part of the reference triangle.
struct Part {
    /// Of degree 8.
    rule: Rule,
    /// Corners and middles of the sides.
    nodes: [[f64; 2]; 6],
}

/// The parts of a triangle after each quartering; those of part k are numbers 4 k to 4 k + 3 of the next.
static PARTS: LazyLock<Vec<Vec<Part>>> = LazyLock::new(|| {
    let mut corners = vec![[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]];
    let mut parts = vec![corners.iter().map(Part::of).collect()];
    for _ in 0..MOST_QUARTERINGS {
        corners = corners.iter().flat_map(quartered).collect();
        parts.push(corners.iter().map(Part::of).collect());
    }
    parts
});

impl Part {
    fn of(corners: &[[f64; 2]; 3]) -> Self {
        let ([a, b, c], [ab, bc, ca]) = (*corners, middles(corners));
        Self {
            rule: Rule::new(Quadrature::for_degree(3).on_part(*corners), 1),
            nodes: [a, b, c, ab, bc, ca],
        }
    }
}

/// The middles of the sides of a triangle.
fn middles(&[a, b, c]: &[[f64; 2]; 3]) -> [[f64; 2]; 3] {
    [(a, b), (b, c), (c, a)].map(|(from, to)| [0, 1].map(|d| 0.5 * (from[d] + to[d])))
}

/// The four congruent parts of a triangle.
fn quartered(corners: &[[f64; 2]; 3]) -> [[[f64; 2]; 3]; 4] {
    let ([a, b, c], [ab, bc, ca]) = (*corners, middles(corners));
    [[a, ab, ca], [ab, b, bc], [ca, bc, c], [bc, ca, ab]]
}

/// What contact carries in this position; `None` where none is simulated.
pub fn share(problem: &FilmProblem, system: &FilmSystem) -> Option<Share> {
    carried(problem, system, Fineness::Full)
}

/// Error of integration [N] of the force of a `share`: its difference from one with a quartering less.
pub fn unsure(problem: &FilmProblem, system: &FilmSystem, share: &Share) -> f64 {
    carried(problem, system, Fineness::Halved).map_or(0.0, |rough| {
        let [x, y] = share.less(&rough).force;
        x.hypot(y)
    })
}

fn carried(problem: &FilmProblem, system: &FilmSystem, fineness: Fineness) -> Option<Share> {
    let law = problem.contact?.law;
    Some(integrated(
        (problem, system),
        &law,
        (fineness, by_contact),
        |points, pressures, sum| {
            add_share(problem, points, pressures.map(|at| at.pressure), sum);
        },
    ))
}

/// First-order change of what contact carries with a `change` of the journal or the gap; zero where none is simulated.
pub fn contact_change(problem: &FilmProblem, system: &FilmSystem, change: FilmChange<'_>) -> Resultant {
    let by_gap = |points: &Points<'_>, pressures: [ContactPressure; MOST_POINTS], sum: &mut Share| {
        let moved = gap_change(problem, change, points);
        add_share(
            problem,
            points,
            std::array::from_fn(|q| pressures[q].slope * moved[q]),
            sum,
        );
    };
    each_point(problem, system, by_contact, by_gap).map_or(Resultant::default(), |share: Share| share.resultant())
}

/// First-order change [m] of the gap at points with a `change` of the journal or the gap.
pub(crate) fn gap_change(problem: &FilmProblem, change: FilmChange<'_>, points: &Points<'_>) -> [f64; MOST_POINTS] {
    let mut film = [FilmPoint::default(); MOST_POINTS];
    let moved = &mut film[..points.positions.len()];
    match change {
        FilmChange::Journal(change) => {
            for contribution in &problem.film_thickness {
                contribution.vary(&change, points.cell, points.positions, moved);
            }
        }
        FilmChange::Gap(shape) => shape.add(&problem.journal, points.cell, points.positions, moved),
        FilmChange::GapRate(_) => {}
    }
    film.map(|point| point.thickness)
}

/// Adds the share of a density [Pa] at points.
fn add_share(problem: &FilmProblem, points: &Points<'_>, density: [f64; MOST_POINTS], sum: &mut Share) {
    let [sines, cosines] = sines_and_cosines(points.positions, problem.bearing.radius);
    for q in 0..points.positions.len() {
        let thrust = points.area(q) * density[q];
        let force = [thrust * cosines[q], thrust * sines[q]];
        *sum += Share {
            force,
            moment: force.map(|force| points.positions[q][1] * force),
            pressure: thrust,
            possible: thrust.abs(),
        };
    }
}

/// The sum over the film of what `add` makes of points and the pressures of contact there; `None` where no contact is simulated. Where surfaces touch, triangles with these corners are
/// quartered at least so often as `quarterings` says.
pub(crate) fn each_point<S: Default + AddAssign + Send>(
    problem: &FilmProblem,
    system: &FilmSystem,
    quarterings: impl Fn(&[[f64; 2]; 3]) -> usize + Sync,
    add: impl Fn(&Points<'_>, [ContactPressure; MOST_POINTS], &mut S) + Sync,
) -> Option<S> {
    let law = problem.contact?.law;
    Some(integrated((problem, system), &law, (Fineness::Full, quarterings), add))
}

/// As often as contact itself asks for.
pub(crate) fn by_contact(_: &[[f64; 2]; 3]) -> usize {
    0
}

/// The sum over the film; triangles are divided where the pressure of contact is steep.
fn integrated<S: Default + AddAssign + Send>(
    (problem, system): (&FilmProblem, &FilmSystem),
    law: &ContactLaw,
    (fineness, quarterings): (Fineness, impl Fn(&[[f64; 2]; 3]) -> usize + Sync),
    add: impl Fn(&Points<'_>, [ContactPressure; MOST_POINTS], &mut S) + Sync,
) -> S {
    let mesh = system.space().mesh();
    let is_film = system.supply.film(mesh);
    integrate(mesh, |t| {
        let (mut sum, mapping) = (S::default(), Mapping::of(mesh, t));
        let least = quarterings(&mesh.corners(t));
        let mut left = if is_film[t] { vec![(0, 0)] } else { Vec::new() };
        while let Some((level, number)) = left.pop() {
            let part = &PARTS[level][number];
            let positions = part.nodes.map(|node| mapping.at(node).position);
            match division(law, &problem.thickness_at(t, &positions), (level, least), fineness) {
                Division::NoContact => {}
                Division::Parts => left.extend((0..4).map(|k| (level + 1, 4 * number + k))),
                Division::Whole => part.rule.visit(mesh, t, |points| {
                    let gaps = problem.gaps_at(t, points.positions);
                    add(points, gaps.map(|gap| law.at(gap)), &mut sum);
                }),
            }
        }
        sum
    })
}

/// What is done with a part of a triangle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Division {
    /// Surfaces do not touch there.
    NoContact,
    /// It is integrated as it is.
    Whole,
    /// It is quartered.
    Parts,
}

/// What is done with a part of a triangle, from the gaps [m] at its nodes; one that touches is quartered to a least level.
fn division(law: &ContactLaw, gaps: &[f64; 6], (level, least_level): (usize, usize), fineness: Fineness) -> Division {
    /// The gap inside of a triangle may be less than that at its nodes by this part of its range.
    const WITHIN: f64 = 0.25;
    let (least, greatest) = gaps
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(least, greatest), &gap| {
            (least.min(gap), greatest.max(gap))
        });
    let least = least - WITHIN * (greatest - least);
    if least >= law.reach() {
        return Division::NoContact;
    }
    let pressure = law.at(least).pressure / law.hardness();
    // How much further it would be divided in full.
    let spared = match fineness {
        Fineness::Full => 0,
        Fineness::Halved => 1,
    };
    if pressure < SLIGHT || level + spared >= MOST_QUARTERINGS {
        return Division::Whole;
    }
    let part = PART * pressure.powf(-1.0 / ORDER);
    // Beyond the reach the gap does not matter.
    let range = greatest.min(law.reach()) - least;
    let is_steep = range > f64::from(1u32 << spared) * part * law.scale();
    let is_kinked = level + spared < KINK_QUARTERINGS && law.has_kink_in(least..greatest);
    match is_steep || is_kinked || level + spared == 0 || level < least_level {
        true => Division::Parts,
        false => Division::Whole,
    }
}
