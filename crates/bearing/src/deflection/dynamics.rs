//! How film and wall answer to small harmonic motions of the journal, together.
//!
//! The film answers to a motion `Re(de exp(i a t))` by `u + i a w`, and to one of the wall alike ([`Whirl`]). The wall
//! follows with `D + i a V`: `D = C (dp/du (u + u(D) - a^2 w(V)) + q + A D)`, `V = C (dp/du (w + w(D) + u(V)) + A V)`:
//! it is elastic and without mass, but the oil that its motion takes up counts. The forces of contact change by q with
//! the motion at a fixed wall, and by A with that of the wall: contact that the wall follows late damps too.

use oilwedge_fem::Error;
use oilwedge_reynolds::film_thickness::Deflection;
use oilwedge_reynolds::{JournalChange, MixedChange, Whirl};

use super::gmres::gmres;
use super::tangent::{Follower, Free};

/// Accuracy of the linear systems.
const EXACT: f64 = 1e-9;

/// How film and wall answer to a motion of the journal.
pub(crate) struct MotionResponse {
    /// Change of the unknown at each dof with the motion as place and as rate [1/s].
    pub(crate) unknown: [Vec<f64>; 2],
    /// Change of the deflection.
    pub(crate) deflection: [Deflection; 2],
}

/// The answer to a motion of the journal by `place`, and as its rate [1/s], from the change of the unknown with both at
/// a fixed wall; of motions at a `frequency` [rad/s], zero: slow ones. The rate of the wall is in units of the `pace`
/// [rad/s] on the way.
///
/// # Errors
/// The linear systems could not be solved.
pub(crate) fn harmonic_response(
    (whirl, follower): (&Whirl<'_>, &Follower<'_>),
    motion: &JournalChange,
    [place, mut rate]: [Vec<f64>; 2],
    frequency: f64,
    pace: f64,
) -> Result<MotionResponse, Error> {
    let pace = if pace > 0.0 { pace } else { 1.0 };
    let through = |motion: &[f64]| -> Result<[Vec<f64>; 2], Error> {
        let (placed, moving) = motion.split_at(motion.len() / 2);
        let [u_place, w_place] = whirl.response_to_gap(&follower.shape(placed))?;
        let [u_rate, w_rate] = whirl.response_to_gap(&follower.shape(moving))?;
        let squared = frequency * frequency / pace;
        Ok([sum(&u_place, -squared, &w_rate), sum(&u_rate, pace, &w_place)])
    };
    rate.iter_mut().for_each(|rate| *rate *= pace);
    let operator = |motion: &[f64]| {
        let (placed, moving) = motion.split_at(motion.len() / 2);
        let [u, w] = through(motion)?;
        let images = [follower.image(&u, placed), follower.image(&w, moving)].concat();
        Ok(sum(motion, -1.0, &images))
    };
    let at_rest = vec![0.0; follower.number()];
    let placed = Free { film: MixedChange::default(), unknown: place, contact: follower.contact_change(motion) };
    let free = [follower.image_of(&placed), follower.image(&rate, &at_rest)].concat();
    let nearly = |motion: &[f64]| {
        let (placed, moving) = motion.split_at(motion.len() / 2);
        Ok([follower.solve_contact(placed), follower.solve_contact(moving)].concat())
    };
    let found = gmres(operator, nearly, &free, EXACT)?.to(EXACT)?;
    let [by_place, by_rate] = through(&found)?;
    let (bent, moving) = found.split_at(found.len() / 2);
    let moving: Vec<f64> = moving.iter().map(|rate| rate / pace).collect();
    let mut rate = sum(&rate, 1.0, &by_rate);
    rate.iter_mut().for_each(|rate| *rate /= pace);
    Ok(MotionResponse {
        unknown: [sum(&placed.unknown, 1.0, &by_place), rate],
        deflection: [follower.shape(bent), follower.shape(&moving)],
    })
}

/// `a + by b`.
fn sum(a: &[f64], by: f64, b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a + by * b).collect()
}
