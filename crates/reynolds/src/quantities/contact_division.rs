//! # Division of triangles: where contact is integrated more finely
//!
//! **Equation.** `Q = (1 - w) Q_0 + w Sum Q_k`: a part of a triangle by its own rule, `Q_0`, and by those of its
//! quarters, `Q_k`, each of which is divided in the same way; `w = s^2 (3 - 2 s)`, `s = (r - r_0)/(1 - r_0)` between 0
//! and 1, r the change of the gap over the part, relative to the greatest that is allowed.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | r, r_0 | 1 | `steepness`, `STEADY` |
//! | w | 1 | [`Division::Quarters`] |
//!
//! The pressure falls to nothing over some roughnesses, far quicker than a film changes: each triangle is quartered,
//! and each part again, until the gap changes little over a part, and further where the law has a kink in it. Contact
//! depends on the gap alone, so that this quadrature, and not the elements of the film, limits its accuracy. The sums
//! are continuous in the gap: those that jump where a part is divided may have no balance with a load, or with the
//! wall, on coarse triangles.
//!
//! **Source.** Strang, Fix, An Analysis of the Finite Element Method (1973): rules on parts of triangles. **Range.**
//! Any law of contact. **Verified by** `loads_are_balanced_where_coarse_triangles_are_divided`, `tests/tests/contact`.

use std::sync::LazyLock;

use oilwedge_fem::Quadrature;
use oilwedge_fem::integrate::Rule;

use crate::contact::{ContactLaw, Fineness};

/// Most times that triangles, and their parts again, are quartered for contact.
const MOST_QUARTERINGS: usize = 5;
/// Order of the error in the length of the parts. Parts are divided until the gap changes by a part of the scale of the
/// law over each, where the pressure is the hardness; an error that falls with the tenth power of the parts is the same
/// for parts that are longer by the tenth root where the pressure is less.
const ORDER: f64 = 10.0;
/// Part of the least pressure at which triangles are quartered, below which, as it is far below what a film or a load
/// is known to, there is no contact.
const NOTHING: f64 = 1e-4;
/// Parts in which the law has a kink are quartered at least so often. With two quarterings on the way to a balance what
/// the weights of quarters add to the tangent, which leaves it out, would make Newton's method slow.
const KINK_QUARTERINGS: usize = 4;
/// Part of the greatest change of the gap from which on the quarters of a part take over.
const STEADY: f64 = 0.85;

/// Accuracy to which contact is integrated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum ContactTolerance {
    /// The accuracy of numbers that are reported.
    Full,
    /// One of lower degree on the same parts, to compare with.
    Lower,
}

impl Fineness {
    /// Change of the gap over a part at the hardness, over the scale of the law.
    fn part(self) -> f64 {
        match self {
            Self::Reported => 0.4,
            // The tenth root of 1e4 times as much.
            Self::Tried => 1.0,
        }
    }

    /// Pressures below this part of the hardness are integrated over triangles as they are.
    fn slight(self) -> f64 {
        match self {
            Self::Reported => 1e-10,
            Self::Tried => 1e-6,
        }
    }
}

/// A part of the reference triangle.
pub(super) struct TrianglePart {
    /// Rule of degree 8.
    pub(super) rule: Rule,
    /// Rule of degree 6: to compare with, and for splines that have a kink amid the part.
    pub(super) lower: Rule,
    /// Corners and middles of the sides.
    pub(super) nodes: [[f64; 2]; 6],
}

/// The parts of a triangle after each quartering; those of part k are numbers 4 k to 4 k + 3 of the next.
pub(super) static PARTS: LazyLock<Vec<Vec<TrianglePart>>> = LazyLock::new(|| {
    let mut corners = vec![[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]];
    let mut parts = vec![corners.iter().map(TrianglePart::of).collect()];
    for _ in 0..MOST_QUARTERINGS {
        corners = corners.iter().flat_map(quartered).collect();
        parts.push(corners.iter().map(TrianglePart::of).collect());
    }
    parts
});

impl TrianglePart {
    fn of(corners: &[[f64; 2]; 3]) -> Self {
        let ([a, b, c], [ab, bc, ca]) = (*corners, middles(corners));
        Self {
            rule: Rule::new(Quadrature::for_degree(3).on_part(*corners), 1),
            lower: Rule::new(Quadrature::for_degree(2).on_part(*corners), 1),
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

/// A part of a triangle that is still to be integrated.
#[derive(Debug, Clone, Copy)]
pub(super) struct PendingPart {
    /// How often the triangle was quartered.
    pub(super) level: usize,
    /// Place of the piece among [`PARTS`].
    pub(super) number: usize,
    /// Whether it counts in what the journal carries, or for the splines of the wall alone.
    pub(super) is_for_load: bool,
    /// Part of its integral that counts [1].
    pub(super) weight: f64,
}

impl PendingPart {
    /// A triangle.
    pub(super) const WHOLE: Self = Self { level: 0, number: 0, is_for_load: true, weight: 1.0 };

    /// The four quarters of the piece.
    pub(super) fn quarters(self) -> impl Iterator<Item = Self> {
        (0..4).map(move |k| Self { level: self.level + 1, number: 4 * self.number + k, ..self })
    }

    /// What its quarters give of it, this part, and what it gives itself; none where that is nothing.
    pub(super) fn shared(self, of_quarters: f64) -> [Option<Self>; 2] {
        [of_quarters, 1.0 - of_quarters].map(|part| (part > 0.0).then_some(Self { weight: self.weight * part, ..self }))
    }

    /// The piece for the splines of the wall alone.
    pub(super) fn for_wall(self) -> Self {
        Self { is_for_load: false, ..self }
    }
}

/// What is done with a part of a triangle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Division {
    /// Surfaces do not touch there.
    NoContact,
    /// The piece is integrated as it is: its pressure is slight, or its parts would be too many.
    Last,
    /// The quarters of the piece give this part of its integral; the splines of the wall may have the rest divided,
    /// too.
    Quarters(f64),
}

/// A step from 0 to 1 between 0 and 1, with a continuous slope.
fn smooth_step(x: f64) -> f64 {
    let x = x.clamp(0.0, 1.0);
    x * x * (3.0 - 2.0 * x)
}

/// What is done with a part of a triangle, from the gaps [m] at its nodes and how often it was quartered.
pub(super) fn division(law: &dyn ContactLaw, fineness: Fineness, gaps: &[f64; 6], level: usize) -> Division {
    /// The gap inside of a triangle may be less than that at its nodes by this part of its range.
    const WITHIN: f64 = 0.25;
    let (least, greatest) = gaps
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(least, greatest), &gap| (least.min(gap), greatest.max(gap)));
    let least = least - WITHIN * (greatest - least);
    let pressure = law.at(least).pressure / law.hardness();
    if pressure < NOTHING * fineness.slight() {
        return Division::NoContact;
    }
    if pressure < fineness.slight() || level >= MOST_QUARTERINGS {
        return Division::Last;
    }
    let part = fineness.part() * pressure.powf(-1.0 / ORDER);
    // Beyond the reach the gap does not matter.
    let range = greatest.min(law.reach()) - least;
    let steepness = range / (part * law.scale());
    let is_kinked = level < KINK_QUARTERINGS && law.has_kink_in(least..greatest);
    Division::Quarters(match is_kinked {
        true => 1.0,
        false => smooth_step((steepness - STEADY) / (1.0 - STEADY)),
    })
}
