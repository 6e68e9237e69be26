//! # Contact: what the asperities of journal and liner carry
//!
//! **Equation.** `W_a = Int p_a(h) (cos phi, sin phi) dA`, `m_a = Int p_a z (cos phi, sin phi) dA`, friction
//! `P_a = mu_b |U| Int p_a dA`; over every triangle of the film, in cavities and at the ends too. Where the journal
//! moves, `dW_a = Int p_a'(h) dh (cos phi, sin phi) dA`.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | p_a, p_a' | Pa, Pa/m | [`crate::contact::ContactLaw::at`] |
//! | W_a, m_a | N, N m | `force`, `moment` of [`share`] |
//! | mu_b | 1 | `friction` |
//!
//! All integrals are sums over the same points ([`super::contact_points`]).
//!
//! **Source.** Definition. **Range.** Friction of contact acts along the surface and carries no load. **Verified by**
//! `tests/tests/contact`.

use super::contact_division::ContactTolerance;
use super::contact_points::ContactPoints;
use super::share::{Resultant, Share};
use crate::{FilmChange, FilmProblem, FilmSystem};

/// What contact carries in this position; `None` where none is simulated.
pub fn share(problem: &FilmProblem, system: &FilmSystem) -> Option<Share> {
    Some(ContactPoints::of_load_alone(problem, system, ContactTolerance::Full)?.share())
}

/// Error of integration [N] of the force of a `share`: its difference from that of a rule of lower degree.
pub fn unsure(problem: &FilmProblem, system: &FilmSystem, share: &Share) -> f64 {
    ContactPoints::of_load_alone(problem, system, ContactTolerance::Lower).map_or(0.0, |rough| {
        let [x, y] = share.less(&rough.share()).force;
        x.hypot(y)
    })
}

/// First-order change of what contact carries with `changes` of the journal or the gap; zero where none is simulated.
pub fn contact_change(problem: &FilmProblem, system: &FilmSystem, changes: &[FilmChange<'_>]) -> Resultant {
    let mut sum = Resultant::default();
    if let Some(points) = ContactPoints::of_load_alone(problem, system, ContactTolerance::Full) {
        for change in changes {
            sum += points.load_change(&points.gap_change(problem, *change));
        }
    }
    sum
}
