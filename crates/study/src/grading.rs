//! Meshes graded for the position that a load leads to.

use std::sync::Arc;

use oilwedge_bearing::{
    BranchLimit, Equilibrium, Heated, InitialGuess, JournalLoad, NoEquilibrium, Purpose, ROUGHLY_BALANCED,
    SearchOptions, Waypoint, find, is_contact,
};
use oilwedge_reynolds::angles::wrapped;
use oilwedge_reynolds::solve::Neighbour;
use oilwedge_reynolds::{FilmProblem, Gap, JournalState};

use crate::compile_error::CompileError;
use crate::film::{Film, Start};
use crate::liner_mesh::expected_triangles;
use crate::model::Model;
use crate::no_answer::NoAnswer;
use crate::observer::Watch;
use crate::position::{FilmState, Position};
use crate::thermal::heating::Heating;

/// Factor between the least film found and the one that a mesh was graded for, from which on it is graded anew.
const REGRADED: f64 = 1.3;
/// Angle [rad] between the thinnest film found and the one that a mesh was graded for, from which on it is graded anew.
const ELSEWHERE: f64 = 0.2;
/// Part of the clearance of the film that a mesh for a journal in contact is graded for.
const THIN: f64 = 0.01;
/// Part of the clearance that rows along the flow are graded for with a parallel journal in contact: they are as dense
/// all along the bearing.
const THIN_IN_ROWS: f64 = 0.2;
/// Gradings of one search.
const GRADINGS: usize = 4;

/// A film on a mesh graded for it.
pub struct Graded {
    /// The film.
    pub film: Film,
    /// Why the load is not balanced, where a coarser mesh is certain of it.
    pub refused: Option<NoEquilibrium>,
}

impl From<Film> for Graded {
    fn from(film: Film) -> Self {
        Self { film, refused: None }
    }
}

/// The film of a model on a mesh with edges of at most `longest` [m]. Under a load a mesh that is made here is graded
/// for the position that the load leads to, as far as the deadline allows, and the journal is where a coarser mesh
/// balances the load.
///
/// # Errors
/// The model does not become a film.
pub fn graded(model: &Arc<Model>, longest: f64, watch: Watch) -> Result<Film, CompileError> {
    Ok(graded_within(model, (longest, f64::INFINITY), None, watch)?.film)
}

/// Where another mesh has shown that a growing moment leads, under a wall that gives way.
#[derive(Debug, Clone)]
pub struct MomentPath {
    /// What its mesh was graded for.
    position: Position,
    way: Arc<Waypoint>,
}

impl MomentPath {
    /// What a film shows by the reason for which it has no answer, or by the way along which it was sought; none where
    /// the journal tips over: at which tilt depends on the mesh.
    pub fn of(film: &Film, reason: &NoAnswer) -> Option<Self> {
        if reason.is_tilt_limit() {
            return None;
        }
        let found = reason.way().cloned().map(Arc::new);
        let way = found.or_else(|| film.way().cloned())?;
        way.is_bent().then(|| Self { position: film.position(), way })
    }
}

/// The film of [`graded`] with no more than about `most_triangles` on a mesh graded anew: a film found much thinner
/// than expected asks for shorter edges everywhere. The search begins where another mesh has shown the way.
///
/// # Errors
/// The model does not become a film.
pub fn graded_within(
    model: &Arc<Model>,
    (longest, most_triangles): (f64, f64),
    shown: Option<&MomentPath>,
    watch: Watch,
) -> Result<Graded, CompileError> {
    let near = |state: &FilmState| {
        let expected = |most: f64| expected_triangles(&model.mesh, longest, state) / most;
        let share = Some(most_triangles).filter(|most| most.is_finite()).map_or(0.0, expected);
        model.film_near(if share > 1.0 { share.sqrt() * longest } else { longest }, state)
    };
    let mut film = match shown {
        None => model.film_near(longest, &model.start())?,
        Some(MomentPath { position, way }) => near(&model.state_at(*position))?.begun(Start::Along(way.clone())),
    };
    let Some(load) = film.load().filter(|_| model.mesh.is_graded()) else {
        return Ok(film.into());
    };
    let mut middle = Some(Position::middle(model));
    for _ in 1..GRADINGS {
        if watch.deadline.is_over() {
            break;
        }
        match suited(&film, load, watch, &mut middle) {
            Suited::To(found) => return Ok(film.as_found(&found).begun(Start::NearlyBalanced).into()),
            Suited::Unknown(way) => {
                let film = match way {
                    Some(way) => film.begun(Start::Along(way)),
                    None => film,
                };
                return Ok(film.into());
            }
            Suited::Failed => return Ok(film.begun(Start::Failed).into()),
            Suited::Refused(reason) => {
                return Ok(Graded { film, refused: Some(reason) });
            }
            Suited::Not(position, known) => {
                let graded = near(&FilmState { position, oil: model.oil_at(known.temperature()) })?;
                film = match known {
                    EarlierSearch::Balance(found) if takes_long(&found, load) => {
                        graded.as_found(&found).begun(Start::NearlyBalanced)
                    }
                    EarlierSearch::Way(way) => graded.begun(Start::Along(way)),
                    EarlierSearch::Balance(_) | EarlierSearch::Nothing => graded,
                };
            }
        }
    }
    Ok(film.into())
}

/// Whether the search for the position of a film takes long, so that it does not begin anew on each mesh.
fn takes_long(problem: &FilmProblem, load: JournalLoad) -> bool {
    problem.has_bent_wall() || problem.cavitation.conserves_oil() && load.tilting.is_some()
}

/// Whether a mesh suits the position that the load leads to.
enum Suited {
    /// The mesh suits the position and the wall of this film, which balances the load roughly.
    To(Box<FilmProblem>),
    /// The mesh does not suit this position, for which it is better graded.
    Not(Position, EarlierSearch),
    /// No position is known, but perhaps the way of a growing moment.
    Unknown(Option<Arc<Waypoint>>),
    /// The search under a wall that gives way has led nowhere.
    Failed,
    /// A growing moment leads into contact under such a wall, or the journal tips over, and a finer mesh would show no
    /// more.
    Refused(NoEquilibrium),
}

/// What a search on one mesh leaves to that on the next.
enum EarlierSearch {
    /// A film that balances the load roughly.
    Balance(Box<FilmProblem>),
    /// The way that a growing moment takes, under a wall that gives way.
    Way(Arc<Waypoint>),
    Nothing,
}

impl EarlierSearch {
    /// The temperature [K] of the film that balances the load.
    fn temperature(&self) -> Option<f64> {
        match self {
            Self::Balance(found) => found.lubricant.temperature,
            Self::Way(_) | Self::Nothing => None,
        }
    }
}

/// Whether the mesh of a film suits the position that the load leads to. `middle` is tried once.
fn suited(film: &Film, load: JournalLoad, watch: Watch, middle: &mut Option<Position>) -> Suited {
    let is_parallel = load.tilting.is_none() && film.problem.journal.tilt == [0.0; 2];
    let thin = match film.problem.cavitation.conserves_oil() && is_parallel {
        true => THIN_IN_ROWS,
        false => THIN,
    };
    // A journal may press the wall out further than the clearance: meshes are those of a thin film in the unbent one.
    let gap = Gap::of(&film.problem.clone().with_wall_at_rest(), &film.system);
    let in_unbent = |problem: &FilmProblem| match problem.deflection() {
        Some(_) => with_film(&gap, &problem.journal, thin),
        None => problem.journal,
    };
    let balance = match rough_balance(film, load, watch) {
        Err(reason) if is_judged(film) && reason.way().is_some() && reason.is_far_beyond() => {
            return Suited::Refused(reason);
        }
        balance => balance,
    };
    // Where walls give way it takes long to follow it anew.
    let way = balance.as_ref().err().and_then(NoEquilibrium::way);
    let way = way.filter(|way| way.is_bent()).cloned().map(Arc::new);
    let journal = match balance.as_ref() {
        Ok(Equilibrium { film, .. }) => in_unbent(&film.problem),
        // How much of a moment is carried near contact is shown by a mesh that resolves the thin film there.
        Err(NoEquilibrium::Branch(end)) if end.is_tilting && end.limit == BranchLimit::Contact => {
            with_film(&gap, &end.journal, thin)
        }
        Err(NoEquilibrium::Branch(_) | NoEquilibrium::BelowRounding { .. }) => return Suited::Unknown(way),
        // Feeds may carry what the estimate would have a thin film carry.
        Err(reason) => match (middle.take(), reason.last_position()) {
            (None, _) if film.problem.deflection().is_some() && !reason.is_far_beyond() => return Suited::Failed,
            (Some(position), _) => return Suited::Not(position, EarlierSearch::Nothing),
            (None, Some(journal)) if is_contact(&gap, &journal) => return Suited::Unknown(None),
            (None, Some(journal)) => with_film(&gap, &journal, thin),
            (None, None) => return Suited::Unknown(None),
        },
    };
    let is_possible = !is_contact(&gap, &journal);
    let suits = is_near(&gap, &in_unbent(&film.problem), &journal);
    match balance {
        Ok(found) if is_possible && suits => Suited::To(Box::new(found.film.problem)),
        Ok(found) if is_possible => Suited::Not(
            Position::of(&journal, gap.bearing().clearance),
            EarlierSearch::Balance(Box::new(found.film.problem)),
        ),
        Err(_) if is_possible && !suits => Suited::Not(
            Position::of(&journal, gap.bearing().clearance),
            way.map_or(EarlierSearch::Nothing, EarlierSearch::Way),
        ),
        _ => Suited::Unknown(way),
    }
}

/// Whether a coarser mesh may be certain that a load has no balance: of a film that conserves oil, under a wall that
/// gives way. Other films tip over on coarse meshes that do not on finer ones.
fn is_judged(film: &Film) -> bool {
    film.problem.deflection().is_some() && film.problem.cavitation.conserves_oil()
}

/// A journal or, where it leaves less than this part of the clearance, one nearer to the middle that leaves it.
fn with_film(gap: &Gap, journal: &JournalState, part: f64) -> JournalState {
    let middle = JournalState { offset: [0.0; 2], tilt: [0.0; 2], ..*journal };
    // On the way to the middle the least film is concave.
    let most = gap.least(&middle);
    let taken = most - gap.least(journal);
    let nearer = f64::min(1.0, (1.0 - part) * most / taken).max(0.0);
    JournalState { offset: journal.offset.map(|e| nearer * e), tilt: journal.tilt.map(|g| nearer * g), ..*journal }
}

/// The balance on a coarser mesh, which is good enough to grade a mesh for, if it leads to a position. A load may be
/// out of reach only because the mesh is too coarse there.
fn rough_balance(film: &Film, load: JournalLoad, watch: Watch) -> Result<Equilibrium, NoEquilibrium> {
    let warming = Heating::of(film);
    let options = SearchOptions {
        accuracy: Some(ROUGHLY_BALANCED),
        warming: warming.as_ref().map(|warming| warming as &dyn Heated),
        // The way into contact under a wall that gives way takes long: what it leads to may be certain on this mesh.
        purpose: match is_judged(film) {
            true => Purpose::Answer,
            false => Purpose::Start,
        },
        ..film.search_options(watch)
    };
    // Where a mesh before has the balance and walls give way, a coarser one that does not is not asked where else there
    // is one, but for a film that conserves oil: it takes longer on a finer mesh.
    let is_asked = film.problem.cavitation.conserves_oil();
    let has_balance = film.start == Start::NearlyBalanced && film.problem.has_bent_wall() && !is_asked;
    let of_coarser = SearchOptions {
        guess: match has_balance {
            true => InitialGuess::Near(Neighbour::None),
            false => options.guess,
        },
        ..options
    };
    let on_coarser = (film.system.coarser.as_ref())
        .map(|coarser| find(&coarser.problem(&film.problem), &coarser.system, load, &of_coarser));
    match on_coarser {
        Some(Ok(found)) => Ok(found),
        // The branch was followed there.
        Some(Err(reason)) if reason.branch_end().is_some() => Err(reason),
        _ => find(&film.problem, &film.system, load, &options),
    }
}

/// Whether a mesh graded for one position suits another.
pub fn is_near(gap: &Gap, graded_for: &JournalState, found: &JournalState) -> bool {
    let [before, now] = [graded_for, found].map(|journal| gap.thinnest(journal));
    let ratio = before.thickness / now.thickness;
    let turn = wrapped(before.angle - now.angle).abs();
    ratio < REGRADED && ratio > 1.0 / REGRADED && turn < ELSEWHERE
}
