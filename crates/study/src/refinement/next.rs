//! The meshes on the way to a tolerance: drawn, given, or divided from the one before.

use std::f64::consts::TAU;
use std::sync::Arc;

use oilwedge_fem::marking::doerfler;
use oilwedge_mesh::refine::{Child, Refined};
use oilwedge_mesh::{Defect, Mesh, refine};
use oilwedge_reynolds::film_thickness::Deflection;

use super::growth::Growth;
use super::level::SolvedLevel;
use crate::compile_error::CompileError;
use crate::film::DEGREE;
use crate::film::Film;
use crate::grading::{Graded, MomentPath, graded, graded_within};
use crate::liner_mesh::{expected_triangles, least_unknowns, liner_mesh};
use crate::mesh_plan::MeshPlan;
use crate::model::Model;
use crate::no_answer::NoAnswer;
use crate::observer::Watch;
use crate::position::{FilmState, Position};
use crate::reasons::Limit;
use crate::result::Refinement;

/// Edges of the first mesh towards a tolerance over those of a mesh that is used as it is.
const FIRST: f64 = 3.0;
/// Least triangles of the first mesh, which has shorter edges where it would have fewer: pictures are not smooth then.
const LEAST_TRIANGLES: usize = 300;
/// Most triangles of that mesh, however thin the film is.
const MOST_TRIANGLES: f64 = 20_000.0;
/// A first mesh of so many unknowns may be made whatever the limit is: a position on 6000 takes 0.4 s.
pub(super) const FIRST_UNKNOWNS: usize = 10_000;
/// Edges of a mesh that follows where the first does not show whether a moment is carried, over those of the first.
const UNDECIDED: f64 = 0.7;
/// Least edges of such a mesh over those of a mesh that is used as it is.
const FINEST: f64 = 0.5;
/// Part of the triangles wanted with which a mesh has enough.
const NEARLY_AS_MANY: f64 = 0.9;
/// Multiple of the triangles wanted with which a mesh has too many.
const TOO_MANY: f64 = 4.0;
/// Most meshes that are drawn to find one with the triangles wanted.
const DRAWN: usize = 5;
/// Share of the indicator that the triangles divided carry.
const SHARE: f64 = 0.7;
/// Triangles of a mesh divided locally over those before: where fewer triangles carry that share they are divided
/// again, [`MOST_DIVISIONS`] times at most.
const LOCAL_GROWTH: f64 = 1.2;
/// Most times that a mesh is divided locally for one step.
const MOST_DIVISIONS: usize = 4;
/// The film of a model on the first mesh on the way to its tolerance.
///
/// # Errors
/// The model does not become a film.
pub fn first_film(model: &Arc<Model>) -> Result<Film, CompileError> {
    let factor = if model.mesh.is_free() { first_factor(model) } else { 1.0 };
    model.film_near(factor * model.mesh.longest, &model.start())
}

/// Edges of the first mesh of a drawn liner over those of one that is used as it is.
fn first_factor(model: &Model) -> f64 {
    factor_for(&model.mesh, FIRST, (LEAST_TRIANGLES, f64::INFINITY), &model.start())
}

/// The factor of the edges, at first `factor`, with which the drawn liner has nearly so many `triangles` or more, and
/// no more than so many times as many: sizes that holes and grooves ask for are not those that the factor changes, and
/// a film thinner than the one of the mesh before asks for shorter edges everywhere.
fn factor_for(plan: &MeshPlan, mut factor: f64, (triangles, most): (usize, f64), state: &FilmState) -> f64 {
    // A film much thinner than that of the mesh before may have far more triangles: to draw it first would take longer
    // than all the rest.
    let expected = expected_triangles(plan, factor * plan.longest, state) / triangles as f64;
    factor *= if expected > most { expected.sqrt() } else { 1.0 };
    for _ in 0..DRAWN {
        // What cannot be drawn is reported where it is to be used.
        let Ok(drawn) = liner_mesh(plan, factor * plan.longest, state) else { break };
        let share = drawn.mesh.triangles().len() as f64 / triangles as f64;
        if (NEARLY_AS_MANY..=most).contains(&share) {
            break;
        }
        factor *= share.sqrt();
    }
    factor
}

/// Most unknowns of a first mesh.
fn first_limit(watch: Watch) -> usize {
    watch.most_unknowns.max(FIRST_UNKNOWNS)
}

/// Unknowns of a first mesh are estimated to within this factor: that of a main bearing with half a groove is 1.6.
const ESTIMATED_WITHIN: f64 = 2.0;

/// Refuses a liner whose first mesh, where it is drawn here, surely has more unknowns than allowed, before it is made.
/// Others are judged by the mesh itself.
///
/// # Errors
/// [`CompileError::BeyondLimit`].
pub(super) fn check_first(model: &Model, watch: Watch) -> Result<(), CompileError> {
    let plan = &model.mesh;
    // What cannot be drawn is reported where it is to be used.
    let least = plan.is_free().then(|| least_unknowns(plan, FIRST * plan.longest, &model.start()).ok()).flatten();
    let surely = least.filter(|least| *least > ESTIMATED_WITHIN * first_limit(watch) as f64);
    surely.map_or(Ok(()), |least| within_limit(plan, least, watch))
}

/// Refuses a first mesh of so many unknowns if there may not be so many.
fn within_limit(plan: &MeshPlan, unknowns: f64, watch: Watch) -> Result<(), CompileError> {
    if unknowns <= first_limit(watch) as f64 {
        return Ok(());
    }
    let liner = &plan.outline.liner;
    let turn = liner.arc.map_or(TAU, |(from, to)| to - from);
    Err(CompileError::BeyondLimit {
        around: turn * liner.radius,
        length: liner.length,
        unknowns,
        most: watch.most_unknowns,
    })
}

/// The next mesh.
pub(super) enum NextMesh {
    /// A mesh made here with longest edges times this, from what a coarser one has shown of the way that a
    /// moment takes.
    Drawn(f64, Option<MomentPath>),
    /// A mesh made here with longest edges times this or less, so that it has about as many triangles as this,
    /// for the film found before.
    DrawnFiner(f64, usize, EarlierFilm),
    /// The mesh as it is given or wanted.
    Given,
    /// A mesh at hand, for the film found before.
    Divided(Arc<Mesh>, Refinement, EarlierFilm),
}

/// What the next film takes over from a film found.
#[derive(Debug, Clone)]
pub(super) struct EarlierFilm {
    /// Where the journal is, as it is given where it is.
    position: Position,
    /// Temperature [K] where it was found.
    temperature: Option<f64>,
    /// How a wall that gives way is bent.
    deflection: Option<Deflection>,
}

impl EarlierFilm {
    fn of(film: &Film) -> Self {
        Self {
            position: match film.load() {
                None => Position::start(&film.model),
                Some(_) => film.position(),
            },
            temperature: film.model.sockets.thermal.and(film.oil.temperature),
            deflection: film.problem.deflection().cloned(),
        }
    }

    /// A film at the position known, under the wall known.
    fn begun(&self, mut film: Film) -> Film {
        film.problem = film.problem.deflected(self.deflection.as_ref());
        film.begun(crate::film::Start::NearlyBalanced)
    }

    /// The state, whose temperature is sought from that found.
    fn state(&self, model: &Model) -> FilmState {
        FilmState { position: self.position, oil: model.oil_at(self.temperature) }
    }
}

impl NextMesh {
    /// The mesh of a film divided uniformly, if its round rims are fine enough for that.
    pub(super) fn divided(film: &Film) -> Option<Self> {
        let divided = refine::uniform(film.system.space().mesh()).ok()?;
        Some(Self::Divided(Arc::new(divided.mesh), Refinement::Uniform, EarlierFilm::of(film)))
    }

    pub(super) fn first(model: &Model) -> Self {
        match model.mesh.is_free() {
            true => Self::Drawn(first_factor(model), None),
            false => Self::Given,
        }
    }

    /// The film on it, and how the mesh was made.
    pub(super) fn film(&self, model: &Arc<Model>, watch: Watch) -> Result<(Refinement, Graded), CompileError> {
        let plan = &model.mesh;
        match self {
            Self::Given => {
                let film = graded(model, plan.longest, watch)?;
                Ok((Refinement::Given, film.into()))
            }
            Self::Drawn(factor, shown) => {
                let most = f64::min(MOST_TRIANGLES, 0.5 * first_limit(watch) as f64) / factor.min(1.0).powi(2);
                let graded = graded_within(model, (factor * plan.longest, most), shown.as_ref(), watch)?;
                within_limit(plan, graded.film.unknowns() as f64, watch)?;
                Ok((Refinement::Given, graded))
            }
            Self::DrawnFiner(factor, triangles, known) => {
                let state = known.state(model);
                let factor = factor_for(plan, *factor, (*triangles, TOO_MANY), &state);
                let film = model.film_near(factor * plan.longest, &state)?;
                Ok((Refinement::Drawn, known.begun(film).into()))
            }
            Self::Divided(mesh, refinement, known) => {
                let film = model.film_on(Mesh::clone(mesh), &known.state(model), DEGREE)?;
                Ok((*refinement, known.begun(film).into()))
            }
        }
    }

    /// Whether it is graded for a position that is to be found.
    pub(super) fn finds_position(&self) -> bool {
        matches!(self, Self::Given | Self::Drawn(..))
    }

    /// How many times the triangles of `film` it has; none where that shows only once it is drawn.
    pub(super) fn growth(&self, film: &Film) -> Option<f64> {
        match self {
            Self::Divided(mesh, ..) => {
                let cells = film.system.space().mesh().triangles().len();
                Some(mesh.triangles().len() as f64 / cells as f64)
            }
            _ => None,
        }
    }

    /// A start on a finer mesh where the first mesh, that of `film`, was too coarse to have an answer.
    pub(super) fn finer_first(&self, film: &Film, reason: &NoAnswer) -> Option<Self> {
        match self {
            Self::Drawn(factor, _) if *factor > 1.0 => Some(Self::Drawn(1.0, MomentPath::of(film, reason))),
            _ => None,
        }
    }

    /// A start on a finer mesh where one that is as fine as usual, that of `film`, does not show whether a moment is
    /// carried.
    pub(super) fn finer_undecided(&self, film: &Film, reason: &NoAnswer) -> Option<Self> {
        match self {
            Self::Drawn(factor, _) if *factor > FINEST && reason.is_undecided() => {
                Some(Self::Drawn(factor * UNDECIDED, MomentPath::of(film, reason)))
            }
            _ => None,
        }
    }

    /// A start on a finer mesh where a rough search on the first mesh has found no balance.
    pub(super) fn finer_than_failed(&self) -> Option<Self> {
        matches!(self, Self::Drawn(factor, _) if *factor > 1.0).then_some(Self::Drawn(1.0, None))
    }

    /// The mesh after that of a level, or why it cannot be made.
    pub(super) fn refined(last: &Self, level: &SolvedLevel, growth: &Growth) -> Result<Self, Limit> {
        let (film, estimated) = (&level.solved.film, &level.estimated);
        let mesh = film.system.space().mesh();
        // A mesh once divided at a front is as fine there as it must be: what is left is divided where it is too
        // coarse.
        let is_fitted = matches!(last, Self::Divided(_, Refinement::Local, _));
        let is_local = !growth.is_stuck && (estimated.is_local || is_fitted || growth.is_bound);
        // Rows along the flow are divided as a whole: a triangle divided for its neighbour's sake lies across it.
        let in_rows = film.problem.cavitation.conserves_oil();
        let (divided, refinement) = match (&estimated.indicator, last) {
            (Some(indicator), _) if is_local && !in_rows => (divided_locally(mesh, indicator), Refinement::Local),
            (_, Self::Drawn(factor, _) | Self::DrawnFiner(factor, ..)) => {
                let triangles = growth.factor * mesh.triangles().len() as f64;
                let factor = factor / growth.factor.sqrt();
                return Ok(Self::DrawnFiner(factor, triangles as usize, EarlierFilm::of(film)));
            }
            _ => (refine::uniform(mesh).map(|divided| divided.mesh), Refinement::Uniform),
        };
        let divided = divided.map_err(|_| Limit::CoarseRim)?;
        Ok(Self::Divided(Arc::new(divided), refinement, EarlierFilm::of(film)))
    }
}

/// A mesh whose triangles with the greatest indicators are divided: once, or as often as it takes for a mesh that is
/// notably larger. At the edge of a cavity the part of a triangle falls with the square of its area.
fn divided_locally(mesh: &Mesh, indicator: &[f64]) -> Result<Mesh, Vec<Defect>> {
    let wanted = LOCAL_GROWTH * mesh.triangles().len() as f64;
    let (mut divided, mut expected) = divided_once(mesh, indicator)?;
    for _ in 1..MOST_DIVISIONS {
        if divided.triangles().len() as f64 >= wanted {
            break;
        }
        match divided_once(&divided, &expected) {
            Ok(further) => (divided, expected) = further,
            Err(_) => break,
        }
    }
    Ok(divided)
}

/// A mesh divided once, and the indicator expected on it.
fn divided_once(mesh: &Mesh, indicator: &[f64]) -> Result<(Mesh, Vec<f64>), Vec<Defect>> {
    let Refined { mesh, lineage } = refine::local(mesh, &doerfler(indicator, SHARE))?;
    let expected = |child: &Child| {
        let [[ax, ay], [bx, by], [cx, cy]] = child.corners;
        let part = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
        indicator[child.parent as usize] * part * part
    };
    Ok((mesh, lineage.iter().map(expected).collect()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compile::compile;
    use std::path::Path;

    #[test]
    fn the_next_mesh_begins_under_the_wall_found() {
        let mut scene = thin_scene("reynolds");
        scene.liner = Some(oilwedge_scene::Liner::Winkler(oilwedge_scene::Layer::Given(1e-13)));
        let film = compile(&scene).and_then(|model| model.film()).expect("a film");
        let wall = film.problem.deflection().expect("a wall");
        let bent = wall.with(vec![1e-6; wall.coefficients.len()]);
        let mut found = film.clone();
        found.problem = found.problem.deflected(Some(&bent));
        let next = EarlierFilm::of(&found).begun(film);
        assert_eq!(next.problem.deflection(), Some(&bent));
        assert_eq!(next.start, crate::film::Start::NearlyBalanced);
    }

    fn thin(model: &str) -> Arc<Model> {
        compile(&thin_scene(model)).expect("a model")
    }

    fn thin_scene(model: &str) -> oilwedge_scene::Scene {
        let text = format!(
            "bearing = {{ diameter = \"100 mm\", length = \"50 mm\", clearance = \"50 um\" }}\n\
             oil = {{ viscosity = \"20 mPa.s\" }}\ncavitation = {{ model = \"{model}\" }}\nends = {{ pressure = \"10 kPa\" }}\n\
             journal = {{ speed = \"100 rad/s\" }}\nload = {{ force = \"1 kN\", angle = \"0 deg\", at = \"2 mm\" }}\n"
        );
        crate::parse(&text, Path::new("a.toml")).expect("a scene")
    }

    #[test]
    fn a_film_found_thinner_is_drawn_with_about_the_triangles_wanted() {
        let model = thin("jfo");
        let plan = &model.mesh;
        let thin = model.state_at(Position { eccentricity: 0.6, min_film_angle: 0.3, tilt: [7.6e-4, 0.0] });
        let triangles =
            |factor: f64| liner_mesh(plan, factor * plan.longest, &thin).expect("a mesh").mesh.triangles().len();
        let wanted = 700;
        assert!(triangles(1.0) as f64 > TOO_MANY * wanted as f64, "{}", triangles(1.0));
        let drawn = triangles(factor_for(plan, 1.0, (wanted, TOO_MANY), &thin)) as f64;
        let share = drawn / wanted as f64;
        assert!((NEARLY_AS_MANY..TOO_MANY).contains(&share), "{share}");
    }

    #[test]
    fn few_triangles_are_divided_until_the_mesh_is_notably_larger() {
        let mesh = thin("reynolds").first_mesh().expect("a mesh").mesh;
        let number = mesh.triangles().len();
        let growth = |mesh: &Mesh| mesh.triangles().len() as f64 / number as f64;
        // Two in a hundred triangles carry all: divided once they make no mesh as large as wanted.
        let few: Vec<f64> = (0..number).map(|t| f64::from(u8::from(t < number / 50))).collect();
        let (once, expected) = divided_once(&mesh, &few).expect("a mesh");
        assert!(growth(&once) < LOCAL_GROWTH && expected.len() == once.triangles().len());
        // The part of a triangle falls with the square of its area: what four quarters carry is a quarter.
        let left = expected.iter().sum::<f64>() / few.iter().sum::<f64>();
        assert!((0.25..0.6).contains(&left), "{left}");
        assert!(growth(&divided_locally(&mesh, &few).expect("a mesh")) >= LOCAL_GROWTH);
        let all = vec![1.0; number];
        let (once, _) = divided_once(&mesh, &all).expect("a mesh");
        let locally = divided_locally(&mesh, &all).expect("a mesh");
        assert_eq!(locally.triangles(), once.triangles());
    }

    /// About as many triangles are drawn as are expected, with and without rows, for a parallel journal and for one
    /// near contact at an end.
    #[test]
    fn about_as_many_triangles_are_expected_as_are_drawn() {
        let parallel = Position { eccentricity: 0.6, min_film_angle: 0.3, tilt: [0.0; 2] };
        let thin = Position { tilt: [7.6e-4, 0.0], ..parallel };
        for model in ["reynolds", "jfo"] {
            let made = super::tests::thin(model);
            let plan = &made.mesh;
            for position in [parallel, thin] {
                let state = made.state_at(position);
                let drawn = liner_mesh(plan, plan.longest, &state).expect("a mesh").mesh.triangles().len() as f64;
                let expected = expected_triangles(plan, plan.longest, &state);
                let share = expected / drawn;
                assert!((0.6..1.7).contains(&share), "{model} {position:?}: {expected} for {drawn}");
            }
        }
    }
}
