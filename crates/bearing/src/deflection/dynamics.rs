//! How film and wall answer to small harmonic motions of the journal, together.
//!
//! The film answers to a motion `Re(de exp(i a t))` by `u + i a w`, and to one of the wall alike ([`Whirl`]). The wall follows with `D + i a V`:
//! `D = C dp/du (u + u(D) - a^2 w(V))`, `V = C dp/du (w + w(D) + u(V))`: it is elastic and without mass, but the oil that its motion takes up counts.

use oilwedge_fem::Error;
use oilwedge_reynolds::Whirl;

use super::gmres::gmres;
use super::tangent::Follower;

/// Accuracy of the linear systems.
const EXACT: f64 = 1e-9;

/// Change of the unknown at each dof with a motion as place and as rate [1/s], from those at a fixed wall; of motions at a `frequency` [rad/s], zero: slow ones. The
/// rate of the wall is in units of the `pace` [rad/s].
///
/// # Errors
/// The linear systems could not be solved.
pub(crate) fn harmonic_response(
    (whirl, follower): (&Whirl<'_>, &Follower<'_>),
    [mut place, mut rate]: [Vec<f64>; 2],
    frequency: f64,
    pace: f64,
) -> Result<[Vec<f64>; 2], Error> {
    let pace = if pace > 0.0 { pace } else { 1.0 };
    let through = |motion: &[f64]| -> Result<[Vec<f64>; 2], Error> {
        let (placed, moving) = motion.split_at(motion.len() / 2);
        let [u_place, w_place] = whirl.response_to_gap(&follower.shape(placed))?;
        let [u_rate, w_rate] = whirl.response_to_gap(&follower.shape(moving))?;
        let squared = frequency * frequency / pace;
        Ok([sum(&u_place, -squared, &w_rate), sum(&u_rate, pace, &w_place)])
    };
    let images = |[place, rate]: [&[f64]; 2]| [follower.image(place), follower.image(rate)].concat();
    rate.iter_mut().for_each(|rate| *rate *= pace);
    let operator = |motion: &[f64]| {
        let [u, w] = through(motion)?;
        Ok(sum(motion, -1.0, &images([&u, &w])))
    };
    let motion = gmres(operator, &images([&place, &rate]), EXACT)?.x;
    let [by_place, by_rate] = through(&motion)?;
    place = sum(&place, 1.0, &by_place);
    rate = sum(&rate, 1.0, &by_rate);
    rate.iter_mut().for_each(|rate| *rate /= pace);
    Ok([place, rate])
}

/// `a + by b`.
fn sum(a: &[f64], by: f64, b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a + by * b).collect()
}
