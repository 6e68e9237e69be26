//! # Contact and wall settled after a step along a tangent, the pressure of the film held
//!
//! Where rough surfaces touch, contact changes by its own size within a roughness. A step along a tangent presses them
//! into each other, and the films after it would undo that by halves. So contact and wall are balanced alone before the
//! next film is solved: the film presses as the tangent has it, contact as its law has it.
//!
//! ```text
//! d' - C f(d') = d - C f_t
//! ```
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | d, d' | m | deflection to which the tangent leads, and the settled one |
//! | f_t, f | N | forces of contact on the splines: along the tangent, and by the law |
//! | C | m/N | [`Wall`](oilwedge_reynolds::wall::Wall) |
//!
//! **Method.** Newton's, at the points of contact found once, under d; its systems by GMRES, whose products cost no
//! back-solve. Contact grows more slowly the further the surfaces part, so that steps from surfaces pressed too hard do
//! not pass the balance. **Verified by** `points_of_contact_follow_the_wall`,
//! `loads_that_press_soft_walls_far_out_are_balanced`.

use std::convert::Infallible;

use oilwedge_reynolds::contact::Contact;
use oilwedge_reynolds::film_thickness::Deflection;
use oilwedge_reynolds::quantities::contact_points::ContactPoints;
use oilwedge_reynolds::{FilmProblem, FilmSystem};

use super::gmres::{gmres, norm};

/// Contact is settled where law and tangent bend the wall differently by more than this part of the deflection.
const APART: f64 = 1e-3;
/// Part of the deflection that settled contact may leave.
const SETTLED: f64 = 1e-4;
/// Most steps of Newton's method.
const MOST_STEPS: usize = 10;
/// Accuracy of the linear systems.
const ACCURACY: f64 = 0.1;

/// The deflection of a problem whose wall was moved along a tangent, contact settled, which presses by these `forces`
/// [N] there; none where both are near, or no contact is simulated.
pub(crate) fn settled(problem: &FilmProblem, system: &FilmSystem, forces: &[f64]) -> Option<Deflection> {
    let (deflection, Contact { law, .. }) = (problem.deflection()?, problem.contact.as_ref()?);
    let mut points = ContactPoints::of(problem, system)?;
    let compliance = &deflection.wall.compliance;
    let size = norm(&deflection.coefficients);
    // d' - d, and C f_t - (d' - d) - C f.
    let mut more = vec![0.0; deflection.coefficients.len()];
    let left_by = |points: &ContactPoints, more: &[f64]| {
        let apart: Vec<f64> = points.forces().iter().zip(forces).map(|(law, tangent)| law - tangent).collect();
        let bent = compliance.deflection(&apart);
        bent.iter().zip(more).map(|(bent, more)| bent - more).collect::<Vec<f64>>()
    };
    let mut left = left_by(&points, &more);
    let first = norm(&left);
    if first < APART * size {
        return None;
    }
    for _ in 0..MOST_STEPS {
        if norm(&left) < SETTLED * size {
            break;
        }
        let tangent = points.tangent();
        let operator = |x: &[f64]| {
            let bent = compliance.deflection(&tangent.times(x));
            Ok::<_, Infallible>(x.iter().zip(bent).map(|(x, bent)| x - bent).collect())
        };
        let Ok(step) = gmres(operator, |r| Ok(r.to_vec()), &left, ACCURACY);
        points = points.bent_further(&**law, &step.x);
        more.iter_mut().zip(&step.x).for_each(|(more, step)| *more += step);
        left = left_by(&points, &more);
    }
    (norm(&left) < first).then(|| deflection.with_more(&more))
}
