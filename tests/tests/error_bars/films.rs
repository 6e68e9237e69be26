//! Films with what judges them.

use std::sync::Arc;

use oilwedge_bearing::Clock;
use oilwedge_reynolds::error_bar::{FilmError, film_error};
use oilwedge_reynolds::quantities::load::{Load, load};
use oilwedge_reynolds::{FilmProblem, FilmSystem, SolvedFilm};
use oilwedge_scene::Scene;
use oilwedge_study::compile::compile;
use oilwedge_study::film::Film;
use oilwedge_study::picture::{FieldChoice, PictureOptions, Surface};
use oilwedge_study::quantities::Quantity;
use oilwedge_study::result::RunResult;
use oilwedge_study::{Interrupt, RunOptions, run};
use oilwedge_tests::scenes::{table, variant};

/// A film in quadratic and in cubic elements, and what is known of the error.
pub(crate) struct Judged {
    pub(crate) film: SolvedFilm,
    pub(crate) cubic: SolvedFilm,
    pub(crate) error: FilmError,
}

impl Judged {
    pub(crate) fn of(problem: FilmProblem, system: &Arc<FilmSystem>) -> Self {
        let film = problem.solve(system).unwrap_or_else(|reason| panic!("{reason}"));
        let cubic = film.cubic_film(None).unwrap_or_else(|reason| panic!("{reason}"));
        let carried = load(&cubic).total;
        let error = film_error(&film, &cubic, &carried, None).expect("duals");
        Self { film, cubic, error }
    }

    pub(crate) fn of_scene(scene: &Scene) -> Self {
        let Film { problem, system, .. } =
            compile(scene).and_then(|model| model.film()).unwrap_or_else(|error| panic!("{error}"));
        Self::of(problem, &system)
    }

    pub(crate) fn quadratic_load(&self) -> Load {
        load(&self.film)
    }

    pub(crate) fn cubic_load(&self) -> Load {
        load(&self.cubic)
    }

    /// Nodes whose pressure was sought in quadratic elements.
    pub(crate) fn unknowns(&self) -> usize {
        let dofs = 0..self.film.system.space().dofs();
        dofs.filter(|&dof| self.film.system.supply.owner(dof).is_none()).count()
    }
}

/// The scene `name` meshed anew from its description with edges of `size` [mm]; its mesh file and tolerance are
/// dropped.
pub(crate) fn drawn(name: &str, size: f64, edit: impl FnOnce(&mut toml::Table)) -> Scene {
    variant(name, |scene| {
        scene.insert("mesh".into(), toml::Table::new().into());
        table(scene, "mesh").insert("size".into(), format!("{size} mm").into());
        edit(scene);
    })
}

/// Sets the key `key` of the table `of`.
pub(crate) fn set(scene: &mut toml::Table, of: &str, key: &str, value: impl Into<toml::Value>) {
    table(scene, of).insert(key.into(), value.into());
}

/// Oil of constant viscosity.
pub(crate) fn constant(scene: &mut toml::Table) {
    table(scene, "oil").remove("barus");
}

/// The result of a scene; it has to be converged.
pub(crate) fn answer(scene: &Scene, options: &RunOptions) -> RunResult {
    let result = run(scene, options).unwrap_or_else(|error| panic!("{error}")).result;
    assert_eq!(result.head.reason, None);
    oilwedge_report::json(&result).expect("all numbers are finite");
    result
}

pub(crate) const NO_BARS: RunOptions = RunOptions {
    picture: PictureOptions { surface: Surface::Cylinder, fields: FieldChoice::Usual },
    bars: false,
    max_seconds: 60.0,
    clock: Clock::Wall,
    max_unknowns: 1_000_000,
    frames: 0,
    curve: false,
    earlier: None,
    interrupt: Interrupt::NEVER,
    observer: None,
};

pub(crate) fn quantity<'a>(result: &'a RunResult, name: &str) -> &'a Quantity {
    result.by_name(name).unwrap_or_else(|| panic!("no {name}"))
}

/// A bar and its value.
pub(crate) fn bar(result: &RunResult, name: &str) -> (f64, f64) {
    let quantity = quantity(result, name);
    let error = quantity.error().unwrap_or_else(|| panic!("{name} has no bar"));
    (quantity.value, error)
}
