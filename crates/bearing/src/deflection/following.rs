//! What the wall adds to the weights of force and moment where it follows an error of the pressure: the dual of film
//! and wall, of which the film is eliminated.
//!
//! ```text
//! mu - C B^T mu = C g        B^T mu = A mu - G^T K^-T F^T mu        g = J_d - G^T K^-T j
//! ```
//!
//! K is the tangent of the film, G how its residual changes with the wall. The operator is the transposed one of
//! `tangent.rs` with C, which is symmetric, before it instead of behind.

use oilwedge_fem::Error;
use oilwedge_reynolds::SolvedFilm;
use oilwedge_reynolds::error_bar::following::{FORCES, FollowingWall, GOALS};

use super::gmres::KrylovSpace;
use super::tangent::Follower;

/// Accuracy of the linear systems: in a soft wall mu and the weight that it is added to are nearly the same.
const ACCURACY: f64 = 1e-4;
/// Part to which each product is known.
const OF_PRODUCTS: f64 = 1e-6;

/// What a wall that gives way adds to the weights of force [1] and, where the journal can tilt, of moment [m] at a
/// solved film, which runs under the wall of `problem`; none where the wall is rigid. Source:
/// [`oilwedge_reynolds::error_bar::following`].
///
/// # Errors
/// The linear systems could not be solved.
pub fn following_wall(film: &SolvedFilm) -> Result<Option<FollowingWall>, Error> {
    let Some(follower) = Follower::of(film)? else {
        return Ok(None);
    };
    let gradient = follower.load_gradient();
    let mut coefficients = [(); GOALS].map(|()| vec![0.0; follower.number()]);
    // A journal that cannot tilt has no moment whose error is asked for.
    let asked = if film.problem.can_tilt() { GOALS } else { FORCES };
    let mut known = KrylovSpace::default();
    for (part, coefficients) in coefficients.iter_mut().enumerate().take(asked) {
        let [by_unknown, by_wall] = gradient.of_part(part);
        *coefficients = follower.weight((&by_unknown, &by_wall), &mut known)?;
    }
    Ok(Some(FollowingWall { grid: follower.deflection.wall.grid.clone(), coefficients }))
}

impl Follower<'_> {
    /// Weight mu of a number that changes with the unknown at each dof and with the coefficients of the wall by so
    /// much; `known` is what the systems of other numbers have shown.
    fn weight(&self, (by_unknown, by_wall): (&[f64], &[f64]), known: &mut KrylovSpace) -> Result<Vec<f64>, Error> {
        let SolvedFilm { problem, system, solution } = self.film;
        let (grid, compliance) = (&self.deflection.wall.grid, &self.deflection.wall.compliance);
        let mut by_all = self.by_film_transposed(by_unknown)?;
        by_all.iter_mut().zip(by_wall).for_each(|(sum, by_wall)| *sum += by_wall);
        let operator = |mu: &[f64]| {
            let weights = grid.weights(problem, system, &solution.unknown, mu);
            let mut forces = self.by_film_transposed(&weights)?;
            if let Some(contact) = self.contact_times(mu) {
                forces.iter_mut().zip(contact).for_each(|(sum, contact)| *sum += contact);
            }
            let image = compliance.deflection(&forces);
            Ok::<_, Error>(mu.iter().zip(image).map(|(mu, image)| mu - image).collect())
        };
        let wanted = compliance.deflection(&by_all);
        known.solve(operator, |r| Ok(self.solve_contact(r)), &wanted, ACCURACY)?.to(ACCURACY)
    }

    /// How a sum over the unknown with these weights of the dofs changes with the wall.
    fn by_film_transposed(&self, weights: &[f64]) -> Result<Vec<f64>, Error> {
        let dual = self.film.answer_transposed(weights, OF_PRODUCTS)?;
        Ok(self.gap.times_transposed(&self.film.system, &dual))
    }
}
