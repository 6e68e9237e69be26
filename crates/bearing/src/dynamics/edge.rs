//! What the edge of a cavity leaves open of stiffness and damping, triangle by triangle.

use oilwedge_fem::Error;
use oilwedge_reynolds::error_bar::edge_products::edge_products;
use oilwedge_reynolds::quantities::LoadGradient;
use oilwedge_reynolds::{SolvedFilm, Whirl};

use super::coefficients::{Coefficients, motion};

/// For each triangle through which the edge of the cavity of a film runs: by how much the coefficients may be off, in
/// proportion, where the edge lies elsewhere in it. A wall that gives way is held.
///
/// # Errors
/// The linear systems could not be solved.
pub fn edge_parts(film: &SolvedFilm) -> Result<Vec<Coefficients>, Error> {
    let order = Coefficients::order_of(&film.problem);
    let whirl = Whirl::new(film, 0.0)?;
    let gradient = LoadGradient::of(film, None);
    let dual = |part: usize| film.solution.linearisation.solve_transposed(&gradient.of_part(part)[0]);
    let duals: Vec<Vec<f64>> = (0..order).map(dual).collect::<Result<_, _>>()?;
    let responses: Vec<[Vec<f64>; 2]> = (0..order)
        .map(|column| {
            let (offset, tilt) = motion(column);
            whirl.response(offset, tilt)
        })
        .collect::<Result<_, _>>()?;
    let of = |kind: usize| {
        let responses: Vec<Vec<f64>> = responses.iter().map(|both| both[kind].clone()).collect();
        edge_products(film, &duals, &responses)
    };
    let both = of(0).into_iter().zip(of(1));
    Ok(both.map(|(stiffness, damping)| Coefficients { stiffness, damping, order }).collect())
}
