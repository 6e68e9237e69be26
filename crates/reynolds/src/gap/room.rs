//! Whether surfaces of any shape leave room for the journal.
//!
//! **Equation.** `max over e of min over (phi, z) of h`. At the place of the least gap `h` is linear in the offset e,
//! so each journal that was looked at bounds the least gap of all others by a plane; the highest point below all planes
//! is the next journal (Kelley 1960). **Verified by** `study`'s tests of ovals.

use super::Gap;
use crate::JournalState;

/// The greatest least gap is known to this part of the clearance.
const EXACT: f64 = 1e-6;
/// Most journals that are looked at.
const MOST: usize = 60;
/// Offset of the first journals, over the clearance.
const FAR: f64 = 4.0;

/// The least gap is at most `level - direction . offset`.
struct Bound {
    direction: [f64; 2],
    level: f64,
}

impl Bound {
    fn at(&self, offset: [f64; 2]) -> f64 {
        self.level - self.direction[0] * offset[0] - self.direction[1] * offset[1]
    }
}

impl Gap {
    /// The greatest least gap [m] that a journal with this tilt may have at any offset, where none leaves a film;
    /// `None` where one does.
    pub fn lack_of_room(&self, journal: &JournalState) -> Option<f64> {
        let clearance = self.bearing.clearance;
        let amid = JournalState { offset: [0.0; 2], ..*journal };
        if self.least_of_one(&amid) > 0.0 {
            return None;
        }
        let mut bounds: Vec<Bound> = Vec::new();
        let mut greatest = f64::NEG_INFINITY;
        let mut look = |offset: [f64; 2], bounds: &mut Vec<Bound>| {
            let place = self.thinnest(&JournalState { offset, ..*journal });
            let (sin, cos) = place.angle.sin_cos();
            let level = place.thickness + cos * offset[0] + sin * offset[1];
            bounds.push(Bound { direction: [cos, sin], level });
            greatest = greatest.max(place.thickness);
            greatest
        };
        let far = FAR * clearance;
        let first = [[0.0, 0.0], [far, 0.0], [0.0, far], [-far, 0.0], [0.0, -far]];
        for offset in first {
            if look(offset, &mut bounds) > 0.0 {
                return None;
            }
        }
        for _ in 0..MOST {
            let (offset, bound) = highest(&bounds, EXACT * clearance)?;
            let greatest = look(offset, &mut bounds);
            if greatest > 0.0 {
                return None;
            }
            if bound - greatest < EXACT * clearance {
                break;
            }
        }
        Some(greatest)
    }
}

/// The offset at which the least of the bounds is greatest, and this bound; `None` where they do not bound it.
fn highest(bounds: &[Bound], slack: f64) -> Option<([f64; 2], f64)> {
    let corner = |[i, j, k]: [usize; 3]| {
        let [a, b, c] = [i, j, k].map(|n| &bounds[n]);
        let [u, v] = [b, c].map(|other| [0, 1].map(|d| other.direction[d] - a.direction[d]));
        let (p, q) = (b.level - a.level, c.level - a.level);
        let determinant = u[0] * v[1] - u[1] * v[0];
        let offset = [(p * v[1] - q * u[1]) / determinant, (u[0] * q - v[0] * p) / determinant];
        let height = a.at(offset);
        let is_below = bounds.iter().all(|bound| height <= bound.at(offset) + slack);
        (height.is_finite() && is_below).then_some((offset, height))
    };
    let mut best: Option<([f64; 2], f64)> = None;
    for i in 0..bounds.len() {
        for j in 0..i {
            for k in 0..j {
                let found = corner([i, j, k]);
                best = match (best, found) {
                    (Some(one), Some(other)) if other.1 > one.1 => Some(other),
                    (one, other) => one.or(other),
                };
            }
        }
    }
    best
}
