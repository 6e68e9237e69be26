//! The wall under contact alone, the pressure of the film held.
//!
//! Where rough surfaces touch, contact changes by its own size within a roughness, and most products of an iteration
//! for film and wall would be spent on it. It acts on few splines, c, so that its part is solved in closed form, and
//! what is left to iterate is how the film answers:
//!
//! ```text
//! x - C A x = r        x = r + C A_c (I - C_c A_c)^-1 r_c
//! ```
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | A | N/m | [`ContactTangent`] |
//! | C | m/N | [`Compliance`] |
//!
//! **Source.** Woodbury's formula; a preconditioner from the right changes no residual. **Verified by**
//! `contact_alone_is_solved_in_closed_form`.

use std::collections::BTreeMap;

use nalgebra::{DMatrix, DVector, Dyn, LU};
use oilwedge_reynolds::wall::{Compliance, ContactTangent};

/// Most splines whose contact is solved so: those that touch hardest.
const MOST_SPLINES: usize = 600;
/// Contact softer than this part of the hardest is left to the iteration.
const LEAST_PART: f64 = 1e-4;

/// Contact on some splines.
pub(super) struct SplineContact {
    /// Numbers of the splines that touch.
    splines: Vec<usize>,
    /// A between them: places in the list, entries [N/m].
    stiffness: Vec<(usize, usize, f64)>,
    /// `I - C_c A_c`.
    factor: LU<f64, Dyn, Dyn>,
}

impl SplineContact {
    /// Contact and wall by a tangent of contact; none where nothing touches.
    pub(super) fn of(contact: &ContactTangent, compliance: &Compliance) -> Option<Self> {
        let splines = hardest(contact)?;
        let places: BTreeMap<usize, usize> = splines.iter().enumerate().map(|(k, &spline)| (spline, k)).collect();
        let mut stiffness = Vec::new();
        contact.each(|row, column, entry| {
            if let (Some(&row), Some(&column)) = (places.get(&row), places.get(&column)) {
                stiffness.push((row, column, entry));
            }
        });
        let among = compliance.among(&splines);
        let mut matrix = DMatrix::identity(splines.len(), splines.len());
        for &(row, column, entry) in &stiffness {
            for (k, compliance) in among.row(row).iter().enumerate() {
                matrix[(k, column)] -= compliance * entry;
            }
        }
        Some(Self { splines, stiffness, factor: matrix.lu() })
    }

    /// Solves `x - C A x = r` with the contact of these splines; r itself where that is singular.
    pub(super) fn solve(&self, compliance: &Compliance, r: &[f64]) -> Vec<f64> {
        let here = DVector::from_iterator(self.splines.len(), self.splines.iter().map(|&spline| r[spline]));
        let Some(moved) = self.factor.solve(&here) else {
            return r.to_vec();
        };
        let mut forces = vec![0.0; r.len()];
        for &(row, column, entry) in &self.stiffness {
            forces[self.splines[row]] += entry * moved[column];
        }
        let bent = compliance.deflection(&forces);
        r.iter().zip(bent).map(|(r, bent)| r + bent).collect()
    }
}

/// The splines that touch hardest; none where nothing touches.
fn hardest(contact: &ContactTangent) -> Option<Vec<usize>> {
    let mut hardness = BTreeMap::<usize, f64>::new();
    contact.each(|row, column, entry| {
        if row == column {
            *hardness.entry(row).or_default() += entry.abs();
        }
    });
    let mut sorted: Vec<(usize, f64)> = hardness.into_iter().collect();
    sorted.sort_by(|a, b| b.1.total_cmp(&a.1));
    let least = LEAST_PART * sorted.first()?.1;
    let hardest = sorted.into_iter().take(MOST_SPLINES).filter(|(_, hard)| *hard > least);
    let mut splines: Vec<usize> = hardest.map(|(spline, _)| spline).collect();
    splines.sort_unstable();
    (!splines.is_empty()).then_some(splines)
}
