//! Newton's method for the deflection, from the wall as it is or, where that fails, from that of a journal nearer to
//! the middle.

use std::sync::Arc;

use oilwedge_fem::newton::Failure;
use oilwedge_reynolds::film_thickness::{Closing, Deflection};
use oilwedge_reynolds::quantities::contact_points::ContactPoints;
use oilwedge_reynolds::solve::Neighbour;
use oilwedge_reynolds::{FilmProblem, FilmSystem, Gap, JournalState, NoFilm, SolvedFilm};

use super::gmres::norm;
use super::tangent::{Follower, contact_points};

/// A deflection is found where what is left of it is below this part;
pub const CLOSED: f64 = 1e-11;
/// or below this one where no shorter step helps, or no step is left.
const CLOSED_ENOUGH: f64 = 1e-8;
/// Most steps.
const MOST_STEPS: usize = 12;
/// Accuracy of the linear system of a first step.
const ROUGH: f64 = 0.1;
/// The linear system of a last step leaves this part of what may be left at last.
const SPARE: f64 = 0.3;
/// A balance of the cubic film that falls by less than this factor is at round-off.
const STALLED: f64 = 0.5;
/// Most lengths of a step, each half of the one before.
const MOST_LENGTHS: i32 = 4;
/// Least gap after a step, over that before.
const LEAST_SHRINK: f64 = 0.1;
/// Growth of the eccentricity [1] from one wall to the next where a film is not found at once.
const CLIMB: f64 = 0.05;
/// Greatest eccentricity at which that growth begins, over that of the film.
const BEGINNING: f64 = 0.5;

/// Both films under one wall, bent by that in cubic elements.
pub struct Pair {
    /// The film in quadratic elements.
    pub film: SolvedFilm,
    /// The film in cubic elements.
    pub cubic: SolvedFilm,
}

/// A film and the deflection under which it was solved, with what is left of the balance.
struct Trial {
    film: SolvedFilm,
    /// What it leaves of the balance of its wall.
    left: Left,
    /// Where the film is least [m]; not known yet of the first one.
    gap: Option<f64>,
}

/// What a film leaves of the balance of its wall.
#[derive(Debug, Clone)]
pub(crate) struct Left {
    /// `C f - d` [m].
    pub(crate) wall: Vec<f64>,
    /// Its part of the deflection [1],
    pub(crate) residual: f64,
    /// whose norm this is [m].
    pub(crate) size: f64,
    /// Where surfaces touch; none where no contact is simulated.
    pub(crate) contact: Option<Arc<ContactPoints>>,
}

/// Solves a film, and with it the deflection of its wall from that which the problem has, or from those of journals
/// nearer to the middle.
///
/// # Errors
/// [`NoFilm`]: the reason why there is none.
pub fn closed_film(problem: FilmProblem, system: &Arc<FilmSystem>, near: Neighbour) -> Result<SolvedFilm, NoFilm> {
    if problem.deflection().is_none() {
        return problem.solve_from(system, near);
    }
    Ok(closed_within(problem, system, near, CLOSED)?.0)
}

/// A film with the deflection found, and its points of contact where that is simulated.
type Closed = (SolvedFilm, Option<Arc<ContactPoints>>);

/// As [`closed_film`], until no more than the part `enough` of the deflection is left.
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
    let mut counts = Closing::default();
    let reason = match closed(problem.clone(), (system, enough), near, &mut counts) {
        Ok(found) => return Ok(found),
        Err(reason) => reason,
    };
    match climbed(&problem, (system, enough), &mut counts) {
        Some(found) => Ok(found),
        None => Err(reason),
    }
}

/// As [`closed_within`], from the deflection that the problem has alone: one that is near.
///
/// # Errors
/// [`NoFilm`]: the reason why there is none, or why the wall is not near.
pub(crate) fn closed_near(
    problem: FilmProblem,
    system: &Arc<FilmSystem>,
    near: Neighbour,
    enough: f64,
) -> Result<Closed, NoFilm> {
    closed(problem, (system, enough), near, &mut Closing::default())
}

/// The film from walls of journals nearer to the middle.
fn climbed(problem: &FilmProblem, system: (&Arc<FilmSystem>, f64), counts: &mut Closing) -> Option<Closed> {
    let eccentricity = problem.journal.eccentricity() / problem.bearing.clearance;
    // In a stage the wall is near to where it was: a rigid one would be far from it.
    let deflection = problem.deflection().filter(|deflection| deflection.rate().is_none())?;
    let rigid = Deflection::none(deflection.wall.clone());
    let at = |part: f64, wall: &Deflection| {
        let journal = nearer(&problem.journal, part);
        FilmProblem { journal, ..problem.clone() }.deflected(Some(wall))
    };
    let step = (CLIMB / eccentricity).min(BEGINNING);
    let mut part = BEGINNING;
    let (mut bent, ..) = closed(at(part, &rigid), system, Neighbour::None, counts).ok()?;
    loop {
        part = (part + step).min(1.0);
        let next = closed(at(part, bent.problem.deflection()?), system, Neighbour::None, counts).ok()?;
        if part == 1.0 {
            return Some(next);
        }
        bent = next.0;
    }
}

/// A journal with a part of its offset and of its tilt.
fn nearer(journal: &JournalState, part: f64) -> JournalState {
    JournalState { offset: journal.offset.map(|x| part * x), tilt: journal.tilt.map(|x| part * x), ..*journal }
}

/// The film by Newton's method.
fn closed(
    problem: FilmProblem,
    (system, enough): (&Arc<FilmSystem>, f64),
    near: Neighbour,
    counts: &mut Closing,
) -> Result<Closed, NoFilm> {
    let film = solved(problem, system, near, counts)?;
    let found = iterated(judged(film), enough, counts)?;
    let residual = found.left.residual;
    let closing = Closing { residual, ..*counts };
    Ok((found.film.closed_by(closing), found.left.contact))
}

/// Newton's method from a film.
fn iterated(mut here: Trial, enough: f64, counts: &mut Closing) -> Result<Trial, NoFilm> {
    for _ in 0..MOST_STEPS {
        if here.left.residual < enough {
            return Ok(here);
        }
        let step = newton_step(&here, accuracy(here.left.residual, enough), counts)?;
        match damped(&here, &step, counts) {
            Some(next) => here = next,
            None if here.left.residual < enough.max(CLOSED_ENOUGH) => return Ok(here),
            None => break,
        }
    }
    match here.left.residual < enough.max(CLOSED_ENOUGH) {
        true => Ok(here),
        false => Err(NoFilm::Wall { residual: here.left.residual, steps: counts.outer }),
    }
}

/// Accuracy of the linear system of a step: one that leaves no more than the curvature does, or than may be left at
/// last (Eisenstat, Walker, SIAM J. Sci. Comput. 17 (1996) 16).
fn accuracy(residual: f64, enough: f64) -> f64 {
    residual.max(SPARE * enough / residual).min(ROUGH)
}

/// The step [m] of Newton's method from a film.
fn newton_step(here: &Trial, accuracy: f64, counts: &mut Closing) -> Result<Vec<f64>, NoFilm> {
    let contact = here.left.contact.clone();
    let follower = Follower::touching(&here.film, contact).map_err(Failure::from)?;
    let Some(follower) = follower else {
        return Ok(Vec::new());
    };
    let solved = follower.solve(&here.left.wall, accuracy).map_err(Failure::from)?;
    counts.inner += solved.steps;
    Ok(solved.x)
}

/// The longest of the halved steps that leaves less of the balance, the gap kept open.
fn damped(here: &Trial, step: &[f64], counts: &mut Closing) -> Option<Trial> {
    let system = &here.film.system;
    let gap = here.gap.unwrap_or_else(|| least_gap(&here.film.problem, system));
    for part in (0..MOST_LENGTHS).map(|times| 0.5f64.powi(times)) {
        let problem = stepped(&here.film.problem, step, part)?;
        let next_gap = least_gap(&problem, system);
        let is_open = next_gap > f64::max(0.0, LEAST_SHRINK * gap);
        let film = is_open.then(|| solved(problem, system, Neighbour::Start(&here.film), counts).ok()).flatten();
        if let Some(film) = film {
            let next = judged(film);
            if next.left.residual < here.left.residual {
                return Some(Trial { gap: Some(next_gap), ..next });
            }
        }
    }
    None
}

/// The problem with a part of a step more of its deflection.
fn stepped(problem: &FilmProblem, step: &[f64], part: f64) -> Option<FilmProblem> {
    let deflection = problem.deflection()?;
    let coefficients = deflection.coefficients.iter().zip(step).map(|(d, step)| d + part * step);
    let next = deflection.with(coefficients.collect());
    Some(problem.clone().deflected(Some(&next)))
}

/// A film under the deflection that the problem has.
fn solved(
    problem: FilmProblem,
    system: &Arc<FilmSystem>,
    near: Neighbour,
    counts: &mut Closing,
) -> Result<SolvedFilm, NoFilm> {
    counts.outer += 1;
    problem.solve_from(system, near)
}

/// A film with what it leaves of the balance of its wall.
fn judged(film: SolvedFilm) -> Trial {
    let left = Left::of(&film, contact_points(&film.problem, &film.system));
    Trial { film, left, gap: None }
}

impl Left {
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

/// Least gap [m] of the film.
fn least_gap(problem: &FilmProblem, system: &FilmSystem) -> f64 {
    Gap::of(problem, system).thinnest_film(problem, system).thickness
}

/// The film in cubic elements from the quadratic `film`, from the cavity of that at a neighbouring place if there is
/// one; a wall that gives way is bent by it, until no more than the part `enough` of the deflection is left.
///
/// # Errors
/// [`NoFilm`]: the reason why there is none.
pub fn closed_pair(film: SolvedFilm, neighbour: Option<&SolvedFilm>, enough: f64) -> Result<Pair, NoFilm> {
    let cubic = film.cubic_film(neighbour)?;
    let mut pair = Pair { film, cubic };
    let Some(deflection) = pair.film.problem.deflection() else {
        return Ok(pair);
    };
    let mut counts = deflection.closing;
    let mut before = f64::INFINITY;
    for step in 0..=MOST_STEPS {
        let contact = contact_points(&pair.film.problem, &pair.film.system);
        let left = Left::of(&pair.cubic, contact);
        let residual = left.residual;
        counts.residual = residual;
        let is_stalled = residual > STALLED * before;
        if residual < enough || residual < CLOSED_ENOUGH && is_stalled {
            return Ok(pair.closed_by(counts));
        }
        if step < MOST_STEPS {
            before = residual;
            pair = bent_further(pair, &left, &mut counts)?;
        }
    }
    match counts.residual < CLOSED_ENOUGH {
        true => Ok(pair.closed_by(counts)),
        false => Err(NoFilm::Wall { residual: counts.residual, steps: counts.outer }),
    }
}

/// Both films under a wall that moves by what is `left` of the balance of the cubic one, along a tangent.
fn bent_further(pair: Pair, left: &Left, counts: &mut Closing) -> Result<Pair, NoFilm> {
    let of = |film| Follower::touching(film, left.contact.clone());
    let quadratic = of(&pair.film).map_err(Failure::from)?;
    let Some(cubic) = of(&pair.cubic).map_err(Failure::from)? else {
        return Ok(pair);
    };
    let follower = cubic.nearly(quadratic);
    let accuracy = accuracy(counts.residual, CLOSED);
    let step = follower.solve(&left.wall, accuracy).map_err(Failure::from)?;
    counts.inner += step.steps;
    let Some(problem) = stepped(&pair.film.problem, &step.x, 1.0) else {
        return Ok(pair);
    };
    // Splines that are coarse beside the film may bend the wall into it.
    if least_gap(&problem, &pair.film.system) <= 0.0 {
        return Err(NoFilm::Wall { residual: counts.residual, steps: counts.outer });
    }
    let film = solved(problem, &pair.film.system, Neighbour::Start(&pair.film), counts)?;
    let cubic = film.cubic_film(Some(&pair.cubic))?;
    Ok(Pair { film, cubic })
}

impl Pair {
    /// These films, whose wall was closed by so much.
    fn closed_by(self, counts: Closing) -> Self {
        Self { film: self.film.closed_by(counts), cubic: self.cubic.closed_by(counts) }
    }
}
