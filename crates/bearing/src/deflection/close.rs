//! The wall of a journal whose place is given: the one Newton's method ([`crate::newton`]) with the deflection as its
//! only unknown around the film.

use std::sync::Arc;

use oilwedge_reynolds::film_thickness::Deflection;
use oilwedge_reynolds::quantities::contact_points::ContactPoints;
use oilwedge_reynolds::solve::Neighbour;
use oilwedge_reynolds::{FilmProblem, FilmSystem, NoFilm, SolvedFilm};

use super::gmres::norm;
use super::tangent::contact_points;
use crate::SearchOptions;
use crate::coupled::FilmSolve;
use crate::newton::{BalanceTolerance, CUBIC_ROUNDING, Damping, Unbalanced};
use crate::search::{Search, Trial};

/// A deflection is found where what is left of it is below this part.
pub const CLOSED: f64 = 1e-11;
/// A deflection that round-off keeps from that is found below this part.
const CLOSED_ENOUGH: f64 = 1e-8;

/// Both films under one wall, bent by that in cubic elements.
pub struct FilmsOnWall {
    /// The film in quadratic elements.
    pub film: SolvedFilm,
    /// The film in cubic elements.
    pub cubic: SolvedFilm,
}

/// What a film leaves of the balance of its wall.
#[derive(Debug, Clone)]
pub(crate) struct WallResidual {
    /// `C f - d` [m].
    pub(crate) wall: Vec<f64>,
    /// Norm of `C f - d` over that of the deflection [1].
    pub(crate) residual: f64,
    /// Norm of the deflection [m].
    pub(crate) size: f64,
    /// Where surfaces touch; none where no contact is simulated.
    pub(crate) contact: Option<Arc<ContactPoints>>,
}

/// Solves a film, and with it the deflection of its wall from that which the problem has.
///
/// # Errors
/// [`NoFilm`]: the reason why there is none.
pub fn closed_film(problem: FilmProblem, system: &Arc<FilmSystem>, near: Neighbour) -> Result<SolvedFilm, NoFilm> {
    Ok(closed_within(problem, system, near, CLOSED)?.0)
}

/// A film with the deflection found, and its points of contact where that is simulated.
type Closed = (SolvedFilm, Option<Arc<ContactPoints>>);

/// Solves a film, and with it the deflection of its wall, until no more than the part `enough` of that is left.
///
/// # Errors
/// [`NoFilm`]: the reason why there is none.
pub(crate) fn closed_within(
    problem: FilmProblem,
    system: &Arc<FilmSystem>,
    near: Neighbour,
    enough: f64,
) -> Result<Closed, NoFilm> {
    if problem.deflection().is_none() {
        let film = problem.solve_from(system, near)?;
        let contact = contact_points(&problem, system);
        return Ok((film, contact));
    }
    let search = Search::held(&problem, system, SearchOptions::default());
    let first = search.open(&problem, [0.0; 4], FilmSolve::Settled(near), enough)?;
    let damping = if problem.has_bent_wall() { Damping::None } else { Damping::PseudoTime };
    let found = closed(&search, first, enough, damping).or_else(|reason| match damping {
        Damping::PseudoTime => Err(reason),
        // What was near leads nowhere.
        Damping::None => {
            let again = search.open(&problem, [0.0; 4], FilmSolve::Settled(near), enough)?;
            closed(&search, again, enough, Damping::PseudoTime)
        }
    })?;
    let found = search.accepted(found)?;
    Ok((found.film, found.contact))
}

/// The trial under the wall that its pressure bends.
fn closed(search: &Search, first: Trial, enough: f64, damping: Damping) -> Result<Trial, NoFilm> {
    let rounding = if first.cubic.is_some() { CUBIC_ROUNDING } else { CLOSED_ENOUGH };
    let goal = BalanceTolerance { balanced: f64::INFINITY, closed: enough, moved: f64::INFINITY, rounding };
    let mut tried = 0;
    search.newton(first, goal, damping, &mut tried).map_err(|Unbalanced { trial, .. }| NoFilm::Wall {
        residual: search.left_of_wall(&trial).residual,
        steps: tried,
    })
}

impl WallResidual {
    /// By the pressure of a film.
    pub(crate) fn of_film(film: &SolvedFilm) -> Self {
        Self::of(film, contact_points(&film.problem, &film.system))
    }

    /// By the pressure of a film with these points of contact.
    pub(crate) fn of(film: &SolvedFilm, contact: Option<Arc<ContactPoints>>) -> Self {
        let SolvedFilm { problem, system, solution } = film;
        let Some(deflection) = problem.deflection() else {
            return Self { wall: Vec::new(), residual: 0.0, size: 0.0, contact };
        };
        let wanted = (deflection.wall).deflection((problem, system), &solution.unknown, contact.as_deref());
        let size = norm(&wanted).max(norm(&deflection.coefficients));
        let wall: Vec<f64> = wanted.iter().zip(&*deflection.coefficients).map(|(wanted, d)| wanted - d).collect();
        Self { residual: if size > 0.0 { norm(&wall) / size } else { 0.0 }, size, wall, contact }
    }
}

/// The film in cubic elements from the quadratic `film`, from the cavity of that at a neighbouring place if there is
/// one; a wall that gives way is bent by it, until no more than the part `enough` of the deflection is left.
///
/// # Errors
/// [`NoFilm`]: the reason why there is none.
pub fn closed_pair(film: SolvedFilm, neighbour: Option<&SolvedFilm>, enough: f64) -> Result<FilmsOnWall, NoFilm> {
    let cubic = film.cubic_film(neighbour)?;
    if film.problem.deflection().is_none() {
        return Ok(FilmsOnWall { film, cubic });
    }
    let system = film.system.clone();
    let search = Search::held(&film.problem, &system, SearchOptions::default());
    let Trial { film, cubic, .. } = closed(&search, search.of_pair(film, cubic), enough, Damping::None)?;
    match cubic {
        Some(cubic) => Ok(FilmsOnWall { film, cubic }),
        None => Err(NoFilm::Wall { residual: f64::INFINITY, steps: 0 }),
    }
}

/// A film whose wall rests in pseudo-time: in the tangent the rate of the wall grows with its deflection by `rate`
/// [1/s]. The wall of a stage of a motion stays in that.
pub(crate) fn resting(film: &SolvedFilm, rate: f64) -> SolvedFilm {
    let in_pseudo_time = |deflection: &Deflection| match deflection.per_time() > 0.0 || rate == 0.0 {
        true => deflection.clone(),
        false => deflection.in_stage(deflection.resting(rate)),
    };
    let deflection = film.problem.deflection().map(in_pseudo_time);
    SolvedFilm { problem: film.problem.clone().deflected(deflection.as_ref()), ..film.clone() }
}
